//! Lists as the children of one element.

/// Reads and writes a `Vec` as the children of one element: `Vec<Unit>` as
/// `<UnitDefinitions><Unit/><Unit/></UnitDefinitions>`.
macro_rules! list_element {
    ($module:ident, $item:ty, $element:literal) => {
        mod $module {
            use serde::{Deserialize, Deserializer, Serialize, Serializer};

            #[derive(Deserialize)]
            struct Read {
                #[serde(rename = $element, default)]
                items: Vec<$item>,
            }

            #[derive(Serialize)]
            struct Write<'a> {
                #[serde(rename = $element)]
                items: &'a [$item],
            }

            pub(super) fn serialize<S: Serializer>(
                items: &[$item],
                serializer: S,
            ) -> Result<S::Ok, S::Error> {
                Write { items }.serialize(serializer)
            }

            pub(super) fn deserialize<'de, D: Deserializer<'de>>(
                deserializer: D,
            ) -> Result<Vec<$item>, D::Error> {
                Read::deserialize(deserializer).map(|read| read.items)
            }
        }
    };
}
pub(crate) use list_element;
