//! What tells scenes apart: their text and files, but for what no result depends on.

use std::borrow::Cow;
use std::ops::Range;

use toml::de::DeTable;

use super::resources::{Attachment, digest};

/// Hash of the text and the attachments in their order; the number of threads does not count.
pub(super) fn hash(text: &str, attachments: &[Attachment]) -> String {
    let text = without_threads(text);
    let files = attachments.iter();
    let files = files.flat_map(|file| [file.path.as_bytes(), &file.content]);
    digest(std::iter::once(text.as_bytes()).chain(files))
}

/// `text` without `threads` of `[simulation]`, and without its line where nothing else is on it.
fn without_threads(text: &str) -> Cow<'_, str> {
    match threads(text) {
        None => Cow::Borrowed(text),
        Some(Range { start, end }) => {
            let (before, after) = (&text[..start], &text[end..]);
            let rest = after.split_inclusive('\n').next().unwrap_or_default();
            let alone = before.is_empty() || before.ends_with('\n');
            let skip = match alone && rest.trim().is_empty() {
                true => rest.len(),
                false => 0,
            };
            Cow::Owned([before, &after[skip..]].concat())
        }
    }
}

/// Where `threads = N` stands in a text.
fn threads(text: &str) -> Option<Range<usize>> {
    // Most scenes have none: they are not read again.
    if !text.contains("threads") {
        return None;
    }
    let table = DeTable::parse(text).ok()?;
    let simulation = table.get_ref().get("simulation")?;
    let entry = simulation.get_ref().as_table()?.get_key_value("threads");
    let (key, value) = entry?;
    let start = text[..key.span().start].trim_end_matches([' ', '\t']).len();
    Some(start..value.span().end)
}

#[cfg(test)]
mod tests {
    use super::without_threads;

    #[test]
    fn only_the_threads_do_not_count() {
        let plain = "title = \"threads\"\n[simulation]\nduration = 1\n";
        for more in ["threads = 2\n", "  threads=16 \n", "threads = 3"] {
            assert_eq!(without_threads(&format!("{plain}{more}")), plain, "{more}");
        }
        assert_eq!(without_threads(plain), plain);
        let inline = |threads: u32| format!("simulation = {{ threads = {threads}, duration = 1 }}");
        assert_eq!(without_threads(&inline(2)), without_threads(&inline(11)));
        let other = "[simulation]\nregisters = \"plain\"\n[fmu]\nthreads = 2\n";
        assert_eq!(without_threads(other), other);
    }
}
