//! Documents as text that shows what has changed, line by line: a short value is one line, a long list of numbers a block.

use serde_json::Value;

/// The widest line that is filled.
const WIDTH: usize = 150;

/// A document with sorted keys, the same text each time.
pub(super) fn text(value: &Value) -> String {
    let mut sorted = value.clone();
    // another crate of the build may have switched serde_json to insertion order
    sorted.sort_all_objects();
    let mut text = String::new();
    write(&sorted, 0, &mut text);
    text.push('\n');
    text
}

fn write(value: &Value, depth: usize, text: &mut String) {
    let line = value.to_string();
    if depth > 0 && line.len() + depth <= WIDTH {
        return text.push_str(&line);
    }
    match value {
        Value::Array(items) if items.iter().all(Value::is_number) => fill(items, depth, text),
        Value::Array(items) => {
            let items = items.iter().map(|item| (String::new(), item));
            block(('[', ']'), items, depth, text);
        }
        Value::Object(table) => {
            let entries = table.iter().map(|(key, own)| (format!("{}: ", Value::from(key.as_str())), own));
            block(('{', '}'), entries, depth, text);
        }
        _ => text.push_str(&line),
    }
}

/// A line an item, or more where it is long.
fn block<'a>(
    (open, close): (char, char),
    items: impl Iterator<Item = (String, &'a Value)>,
    depth: usize,
    text: &mut String,
) {
    text.push(open);
    for (index, (head, item)) in items.enumerate() {
        text.push_str(if index == 0 { "\n" } else { ",\n" });
        text.extend(std::iter::repeat_n(' ', depth + 1));
        text.push_str(&head);
        write(item, depth + 1, text);
    }
    text.push('\n');
    text.extend(std::iter::repeat_n(' ', depth));
    text.push(close);
}

/// As many numbers in a line as it takes.
fn fill(items: &[Value], depth: usize, text: &mut String) {
    let indent = format!("\n{}", " ".repeat(depth + 1));
    text.push('[');
    let mut length = usize::MAX / 2;
    for (index, item) in items.iter().enumerate() {
        let word = item.to_string();
        if index > 0 {
            text.push(',');
        }
        if length + word.len() > WIDTH {
            text.push_str(&indent);
            length = depth + 1;
        } else {
            text.push(' ');
        }
        text.push_str(&word);
        length += word.len() + 2;
    }
    text.push_str(&indent[..=depth]);
    text.push(']');
}
