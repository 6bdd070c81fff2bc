//! The FMU as a component of WebAssembly, by the draft FMI-LS-WASM: the module that `fmu/platforms/build wasm` makes, with the
//! resources of the scene in its memory, since a component sees no files.

use std::collections::BTreeMap;
use std::ops::Range;

use thiserror::Error;
use wasm_encoder::{
    ConstExpr, DataCountSection, DataSection, MemorySection, MemoryType, Module, RawSection,
};
use wasmparser::{BinaryReaderError, ExternalKind, Operator, Parser, Payload};
use wit_component::ComponentEncoder;

/// What the module tells the place by: two numbers, address and size.
const PLACE: &str = "SPHERE_DDA_RESOURCES";
/// Bytes of a page of memory.
const PAGE: u64 = 65536;

/// The manifest of the layered standard inside an FMU.
pub(crate) const MANIFEST_FILE: &str = "extra/org.modelica.fmi-ls-wasm/manifest.xml";
/// Its content.
pub(crate) const MANIFEST: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<fmiLayeredStandardManifest xmlns:fmi-ls="http://fmi-standard.org/fmi-ls-manifest" fmi-ls:fmi-ls-name="org.modelica.fmi-ls-wasm" fmi-ls:fmi-ls-version="0.1.0" fmi-ls:fmi-ls-description="FMI Layered Standard for WebAssembly"/>
"#;

/// Why there is no component.
#[derive(Debug, Error)]
pub enum ComponentError {
    /// Not a module.
    #[error(transparent)]
    Module(#[from] BinaryReaderError),
    /// A module without place for resources.
    #[error("found no `{PLACE}` in the module, expected one of `fmu/platforms/build wasm`")]
    NoPlace,
    /// Resources that do not fit beside the module.
    #[error(
        "found resources of {0} bytes, expected less than 2 GiB: a component has a memory of 4 GiB"
    )]
    Size(usize),
    /// They cannot be written.
    #[error(transparent)]
    Resources(#[from] postcard::Error),
    /// The module is no FMU, says the encoder.
    #[error("{0}")]
    Encoder(String),
}

/// The component of `module` with `resources`, by their names.
///
/// # Errors
/// [`ComponentError`].
pub fn component(
    module: &[u8],
    resources: &BTreeMap<&str, &[u8]>,
) -> Result<Vec<u8>, ComponentError> {
    let module = core_module(module, resources)?;
    let mut encoder = ComponentEncoder::default();
    encoder.validate(true);
    let encoded = encoder.module(&module).and_then(ComponentEncoder::encode);
    encoded.map_err(|error| ComponentError::Encoder(format!("{error:#}")))
}

/// The core module of the component: `module` with `resources` in its memory.
///
/// # Errors
/// [`ComponentError`], but for its encoder.
pub fn core_module(
    module: &[u8],
    resources: &BTreeMap<&str, &[u8]>,
) -> Result<Vec<u8>, ComponentError> {
    with_resources(module, &postcard::to_stdvec(resources)?)
}

/// `module` with `content` behind its memory.
fn with_resources(module: &[u8], content: &[u8]) -> Result<Vec<u8>, ComponentError> {
    if content.len() >= 1 << 31 {
        return Err(ComponentError::Size(content.len()));
    }
    // A file that is in memory.
    let of = |range: Range<u64>| range.start as usize..range.end as usize;
    let mut changed = Module::new();
    let mut address = 0;
    let mut globals = Vec::new();
    let mut place = None;
    for payload in Parser::new(0).parse_all(module) {
        let payload = payload?;
        match &payload {
            Payload::MemorySection(memories) => {
                let mut section = MemorySection::new();
                for memory in memories.clone() {
                    let memory = memory?;
                    address = memory.initial * PAGE;
                    section.memory(MemoryType {
                        minimum: memory.initial + (content.len() as u64).div_ceil(PAGE),
                        maximum: memory.maximum,
                        memory64: memory.memory64,
                        shared: memory.shared,
                        page_size_log2: memory.page_size_log2,
                    });
                }
                changed.section(&section);
                continue;
            }
            Payload::DataCountSection { count, .. } => {
                changed.section(&DataCountSection { count: count + 2 });
                continue;
            }
            Payload::DataSection(segments) => {
                let place = place.ok_or(ComponentError::NoPlace)?;
                let mut section = DataSection::new();
                for segment in segments.clone() {
                    section.raw(&module[of(segment?.range)]);
                }
                let told = [address as u32, content.len() as u32].map(u32::to_le_bytes);
                section.active(0, &ConstExpr::i32_const(place), told.concat());
                section.active(
                    0,
                    &ConstExpr::i32_const(address as i32),
                    content.iter().copied(),
                );
                changed.section(&section);
                continue;
            }
            Payload::GlobalSection(all) => {
                for global in all.clone() {
                    let value = global?.init_expr.get_operators_reader().read()?;
                    globals.push(match value {
                        Operator::I32Const { value } => Some(value),
                        _ => None,
                    });
                }
            }
            Payload::ExportSection(exports) => {
                for export in exports.clone() {
                    let export = export?;
                    if export.name == PLACE && export.kind == ExternalKind::Global {
                        place = globals.get(export.index as usize).copied().flatten();
                    }
                }
            }
            _ => {}
        }
        if let Some((id, range)) = payload.as_section() {
            changed.section(&RawSection {
                id,
                data: &module[of(range)],
            });
        }
    }
    place.ok_or(ComponentError::NoPlace)?;
    Ok(changed.finish())
}
