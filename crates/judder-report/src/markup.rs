//! The small markup of labels: `_{…}` and `^{…}` lower and raise, `$…$` sets symbols.
//!
//! Between dollars letters are italic, digits and signs upright, and a subscript of several letters (`τ̃_{0,crit}`)
//! upright, as journals want it. Everything else is Unicode: `"Shear strength $τ̃_{0}$"`, `"10^{−3}"`, `"5 m s^{−1}"`.
//! A dollar without a partner, and a brace without `_` or `^`, stand for themselves.

/// A piece of text set in one way.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct TextSpan {
    /// The characters.
    pub(crate) text: String,
    /// 0 on the line, −1 lowered, 1 raised, −2 lowered twice, …
    pub(crate) level: i8,
    /// Set in italics.
    pub(crate) italic: bool,
}

/// Deeper nesting is set at the deepest level rather than smaller and smaller.
const DEEPEST: i8 = 2;

/// Splits a label into spans.
pub(crate) fn parse(label: &str) -> Vec<TextSpan> {
    let characters: Vec<char> = label.chars().collect();
    let mut spans = Vec::new();
    let mut text = String::new();
    // the signs of the levels that are open, and whether symbols are being set
    let mut open: Vec<i8> = Vec::new();
    let mut symbols = false;
    let (closed, last_dollar) = (closed(&characters), characters.iter().rposition(|sign| *sign == '$'));
    let mut index = 0;
    while let (Some(&character), Some(&opens)) = (characters.get(index), closed.get(index)) {
        let partner = symbols || last_dollar.is_some_and(|last| last > index);
        let turns = character == '$' && open.is_empty() && partner;
        let ends = character == '}' && !open.is_empty();
        if opens || turns || ends {
            push(&mut spans, &mut text, &open, symbols);
        }
        if opens {
            open.push(if character == '_' { -1 } else { 1 });
            index += 1;
        } else if turns {
            symbols = !symbols;
        } else if ends {
            open.pop();
        } else {
            text.push(character);
        }
        index += 1;
    }
    push(&mut spans, &mut text, &open, symbols);
    spans
}

/// Where groups begin that are closed again: at their `_` or `^`. Found in one pass, as labels may be of any length.
fn closed(characters: &[char]) -> Vec<bool> {
    let (mut closed, mut open) = (vec![false; characters.len()], Vec::new());
    for (index, pair) in characters.windows(2).enumerate() {
        match pair {
            ['_' | '^', '{'] => open.push(index),
            [_, '}'] => {
                if let Some(start) = open.pop().and_then(|start: usize| closed.get_mut(start)) {
                    *start = true;
                }
            }
            _ => {}
        }
    }
    closed
}

/// Ends the piece of text that is being read.
fn push(spans: &mut Vec<TextSpan>, text: &mut String, open: &[i8], symbols: bool) {
    let text = std::mem::take(text);
    if text.is_empty() {
        return;
    }
    let depth = (open.len().min(DEEPEST as usize)) as i8;
    let level = open.last().map_or(0, |sign| sign * depth);
    let italics = symbols && !(level != 0 && has_word(&text));
    if !italics {
        spans.push(TextSpan { text, level, italic: false });
        return;
    }
    let mut run = String::new();
    let mut run_italic = false;
    for character in text.chars() {
        // a hat or tilde belongs to the letter before it
        let italic = if is_combining(character) { run_italic } else { is_symbol_letter(character) };
        if italic != run_italic && !run.is_empty() {
            spans.push(TextSpan { text: std::mem::take(&mut run), level, italic: run_italic });
        }
        run_italic = italic;
        run.push(character);
    }
    spans.push(TextSpan { text: run, level, italic: run_italic });
}

/// Two letters in a row make a word, which is an abbreviation and not a product.
fn has_word(text: &str) -> bool {
    let letters: Vec<bool> = text.chars().filter(|c| !is_combining(*c)).map(char::is_alphabetic).collect();
    letters.windows(2).any(|pair| pair == [true, true])
}

fn is_combining(character: char) -> bool {
    ('\u{300}'..='\u{36f}').contains(&character)
}

/// Latin and small Greek letters are set in italics; capital Greek ones stay upright.
fn is_symbol_letter(character: char) -> bool {
    character.is_alphabetic() && !('\u{391}'..='\u{3a9}').contains(&character)
}

/// The label as HTML: `<sub>`, `<sup>`, `<i>`, everything else escaped.
pub(crate) fn html(label: &str) -> String {
    parse(label).into_iter().map(|span| span_html(&span)).collect()
}

fn span_html(span: &TextSpan) -> String {
    let depth = usize::from(span.level.unsigned_abs());
    let (open, close) = if span.level < 0 { ("<sub>", "</sub>") } else { ("<sup>", "</sup>") };
    // a number and its power of ten stay on one line
    let text = escape(&span.text).replace(" × ", "\u{a0}×\u{a0}");
    let text = if span.italic { format!("<i>{text}</i>") } else { text };
    format!("{}{text}{}", open.repeat(depth), close.repeat(depth))
}

/// The label without its markup, for places that take bare text.
pub(crate) fn plain(label: &str) -> String {
    parse(label).into_iter().map(|span| span.text).collect()
}

/// The label without its markup, for attributes and titles of XML and HTML.
pub(crate) fn plain_html(label: &str) -> String {
    escape(&plain(label))
}

/// Text for XML and HTML; characters that XML forbids become U+FFFD.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            '\'' => out += "&#39;",
            '\t' | '\n' | '\r' => out.push(character),
            '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            _ => out.push(character),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_and_scripts_become_html() {
        assert_eq!(html("Load $F̃_{n}$ (−)"), "Load <i>F̃</i><sub><i>n</i></sub> (−)");
        assert_eq!(html("$τ̃_{0,crit}$"), "<i>τ̃</i><sub>0,crit</sub>");
        assert_eq!(html("10^{−3} m"), "10<sup>−3</sup> m");
        assert_eq!(html("$E_{0}^{*}$"), "<i>E</i><sub>0</sub><sup>*</sup>");
        assert_eq!(html("a_{b_{c}}"), "a<sub>b</sub><sub><sub>c</sub></sub>");
    }

    #[test]
    fn what_is_not_markup_stands_for_itself() {
        assert_eq!(html("a_b {c} 5 $ <&\">"), "a_b {c} 5 $ &lt;&amp;&quot;&gt;");
        assert_eq!(html("x_{open"), "x_{open");
        assert_eq!(html("}"), "}");
        assert_eq!(html(""), "");
        assert_eq!(plain("$τ̃_{0}$ & co"), "τ̃0 & co");
    }

    #[test]
    fn long_labels_are_read_in_one_pass() {
        let start = std::time::Instant::now();
        for part in ["_{", "a", "$", "_{a}"] {
            assert!(parse(&part.repeat(400_000 / part.len())).len() < 400_000, "{part}");
        }
        assert!(start.elapsed().as_secs() < 5, "{:?}", start.elapsed());
    }

    #[test]
    fn control_characters_do_not_reach_the_page() {
        assert_eq!(escape("a\u{0}b\u{b}c\nd"), "a\u{fffd}b\u{fffd}c\nd");
    }
}
