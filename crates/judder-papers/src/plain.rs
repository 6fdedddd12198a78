//! Labels of the report for a terminal and for programs, which have no italics and no subscripts.

/// `$τ̃_{0,crit}$ ≈ 10^{−2}` as `τ̃_0,crit ≈ 10⁻²`.
#[must_use]
pub fn plain(label: &str) -> String {
    let mut pieces = label.split("^{");
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        match piece.split_once('}') {
            Some((exponent, rest)) => text.extend([raised(exponent).as_str(), rest]),
            None => text.extend(["^", piece]),
        }
    }
    text.replace("_{", "_").replace(['$', '}'], "")
}

/// `−3` as `⁻³`; `^*` where Unicode has nothing raised.
fn raised(exponent: &str) -> String {
    let raised: Option<String> = exponent.chars().map(raised_character).collect();
    raised.unwrap_or_else(|| format!("^{exponent}"))
}

fn raised_character(character: char) -> Option<char> {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    match character {
        '−' | '-' => Some('⁻'),
        digit => DIGITS.get(digit.to_digit(10)? as usize).copied(),
    }
}

#[cfg(test)]
mod tests {
    use super::plain;

    #[test]
    fn markup_becomes_characters() {
        assert_eq!(plain("$τ̃_{0,crit}$ ≈ 3.5 × 10^{−12}"), "τ̃_0,crit ≈ 3.5 × 10⁻¹²");
        assert_eq!(plain("$E_{0}^{*}$ R^{2}"), "E_0^* R²");
        assert_eq!(plain("no markup, $ξ$"), "no markup, ξ");
    }
}
