//! How objects show themselves in a notebook.

/// A heading and a table of two columns; rows without content are left out.
pub(crate) fn shown(heading: &str, rows: &[(&str, String)]) -> String {
    let told = rows.iter().filter(|(_, content)| !content.is_empty());
    let cells: String = told
        .map(|(name, content)| format!("<tr><th>{}</th><td>{}</td></tr>", escaped(name), escaped(content)))
        .collect();
    format!("<h4>{}</h4><table>{cells}</table>", escaped(heading))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
