//! Tables of text, a header line and lines of fields.

/// The lines of a table by their numbers, counted from 1, parted into fields at semicolons, tabs or commas, whichever the first has, in this order. Empty lines
/// and lines that begin with `#` are left out.
pub(crate) fn lines_of_fields(text: &str) -> impl Iterator<Item = (usize, Vec<&str>)> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let numbered = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    let lines = numbered.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let mut known = None;
    lines.map(move |(number, line)| {
        let found = || [';', '\t'].into_iter().find(|candidate| line.contains(*candidate)).unwrap_or(',');
        let separator = *known.get_or_insert_with(found);
        (number, line.split(separator).map(unquoted).collect())
    })
}

/// `force [N]` or `force (N)` as `force ` and `N`.
pub(crate) fn parted(column: &str) -> (&str, Option<&str>) {
    let opening = column.find(['[', '(']);
    let unit = opening.and_then(|at| column[at + 1..].strip_suffix([']', ')'])).map(str::trim);
    (&column[..opening.unwrap_or(column.len())], unit)
}

/// A field without the quotes around it.
fn unquoted(field: &str) -> &str {
    let field = field.trim();
    field.strip_prefix('"').and_then(|inner| inner.strip_suffix('"')).unwrap_or(field)
}
