//! The text that an error points into; where its lines are too long to be quoted whole, a part around the place.

use std::sync::Arc;

use miette::{MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};

/// The most that an error quotes, bytes.
pub(crate) const QUOTED: usize = 2000;

/// What remains on either side of the place where more than [`QUOTED`] would be quoted, bytes.
const MARGIN: usize = 100;

/// A named text that is quoted in parts of bounded length.
#[derive(Debug)]
pub(crate) struct QuotedSource {
    pub(crate) name: String,
    pub(crate) text: Arc<str>,
}

impl QuotedSource {
    /// `span`, or as much of its beginning as is quoted.
    pub(crate) fn shorten(&self, span: SourceSpan) -> SourceSpan {
        let start = span.offset();
        let end = self.text.floor_char_boundary(start + span.len().min(QUOTED));
        (start, end.saturating_sub(start)).into()
    }
}

impl SourceCode for QuotedSource {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        lines_before: usize,
        lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let lines = self.text.read_span(span, lines_before, lines_after)?;
        let (start, end) = (lines.span().offset(), lines.span().offset() + lines.span().len());
        let (mut from, mut to) = (start, end);
        if end - start > QUOTED {
            from = start.max(self.text.floor_char_boundary(span.offset().saturating_sub(MARGIN)));
            to = end.min(self.text.floor_char_boundary(span.offset() + span.len() + MARGIN));
        }
        let skipped = self.text[start..from].matches('\n').count();
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            &self.text.as_bytes()[from..to],
            (from, to - from).into(),
            lines.line() + skipped,
            lines.column(),
            lines.line_count(),
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quoted(text: &str, span: (usize, usize)) -> (String, usize) {
        let source = QuotedSource { name: "case.toml".to_owned(), text: Arc::from(text) };
        let span = source.shorten(span.into());
        let contents = source.read_span(&span, 1, 1).unwrap();
        (String::from_utf8(contents.data().to_vec()).unwrap(), contents.line())
    }

    #[test]
    fn short_lines_are_quoted_whole() {
        assert_eq!(quoted("a = 1\nb = 2\nc = 3\nd = 4\n", (12, 1)), ("b = 2\nc = 3\nd = 4\n".to_owned(), 1));
    }

    #[test]
    fn long_lines_are_quoted_in_part() {
        let comment = format!("# {}\n", "τ".repeat(500_000));
        let (text, line) = quoted(&format!("{comment}key = 1\n{comment}"), (comment.len(), 3));
        assert!(text.contains("τ\nkey = 1\n# τ") && text.len() < 250, "{text}");
        assert_eq!(line, 0);
        let (text, line) = quoted(&format!("{comment}\n\nkey = \"{comment}"), (comment.len() + 2, 3));
        assert!(text.contains("\nkey = \"# τ") && text.len() < 250, "{text}");
        assert_eq!(line, 2);
        assert_eq!(quoted(&format!("a = 1\n{comment}"), (5000, 0)).1, 1);
        assert!(quoted(&comment, (0, comment.len())).0.len() <= QUOTED + MARGIN);
        assert!(quoted(&comment, (0, 0)).0.len() <= MARGIN);
    }
}
