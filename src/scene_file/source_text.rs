//! The text of a scene as messages show it: of a very long line a part.

use miette::{MietteError, MietteSpanContents, NamedSource, SourceCode, SourceSpan, SpanContents};

/// Longest line \[byte\] that is shown whole.
const WHOLE: usize = 1000;
/// Bytes shown on each side of the place in a longer one.
const AROUND: usize = 60;
/// Most bytes that a message points at.
const MOST: usize = 200;

/// Name and text of a scene file.
#[derive(Debug, Clone)]
pub(crate) struct SourceText(NamedSource<String>);

impl SourceText {
    pub(crate) fn new(name: &str, text: String) -> Self {
        Self(NamedSource::new(name, text))
    }

    pub(crate) fn name(&self) -> &str {
        self.0.name()
    }
}

/// The part of `start..end` in `text` that a message points at: of its first line, and not too much.
pub(super) fn pointed_at(text: &str, start: usize, end: usize) -> SourceSpan {
    let start = start.min(text.len());
    let end = end.clamp(start, text.len());
    let line = text.as_bytes()[start..end].iter().position(|&b| b == b'\n');
    let end = line.map_or(end, |n| start + n);
    (start..text.floor_char_boundary(end.min(start + MOST)).max(start)).into()
}

impl SourceCode for SourceText {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let whole = self.0.read_span(span, before, after)?;
        if whole
            .data()
            .split(|&b| b == b'\n')
            .all(|line| line.len() <= WHOLE)
        {
            return Ok(whole);
        }
        let text = self.0.inner();
        let (start, end) = (span.offset(), span.offset() + span.len());
        let line = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let next = text[end..].find('\n').map_or(text.len(), |at| end + at);
        let from = text
            .floor_char_boundary(start.saturating_sub(AROUND))
            .max(line);
        let to = text.ceil_char_boundary(end + AROUND).min(next);
        let number = text[..start].matches('\n').count();
        Ok(Box::new(MietteSpanContents::new_named(
            self.name().to_owned(),
            &text.as_bytes()[from..to],
            (from..to).into(),
            number,
            from - line,
            1,
        )))
    }
}
