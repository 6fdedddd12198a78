//! The `[parameters]` of a case, which stand in its expressions: what sets or varies one has to name one that something follows.

use super::{Data, Node, read_option};
use crate::cause::Cause;
use crate::error::{Fault, Place};

/// What a key that is varied and stands for none of the parameters of its case should name.
pub const PARAMETER: &str = "parameter";

/// By which key the parameters are called.
pub const PARAMETERS: &str = "parameters";

impl Node {
    /// Puts a value of a key that is varied at the end of its dotted path, as [`set`](Self::set) does: of a case whose every other key may be left out for its default, a parameter has to be
    /// there, and in some expression, for nothing follows one of another name.
    pub fn vary(&mut self, path: &str, place: Place, leaf: Node) -> Result<(), Fault> {
        if let Some(name) = parameter(path) {
            if !self.has_parameter(name) {
                return Err(self.unknown_parameter(path).at(place));
            }
            if !self.names_parameter(name) {
                return Err(Cause::UnusedParameter { path: path.to_owned() }.at(place));
            }
        }
        self.set(path, place, leaf)
    }

    /// That there is no parameter at this path.
    fn unknown_parameter(&self, path: &str) -> Cause {
        let known = match self.entry(PARAMETERS).map(|own| &own.data) {
            Some(Data::Table(table)) => {
                table.entries.iter().map(|own| format!("{PARAMETERS}.{}", own.key)).collect()
            }
            _ => Vec::new(),
        };
        Cause::UnknownName { what: PARAMETER, name: path.to_owned(), known }
    }

    fn has_parameter(&self, name: &str) -> bool {
        self.entry(PARAMETERS).is_some_and(|own| own.entry(name).is_some())
    }

    /// Whether a text beside the parameters themselves has this word, as expressions do; the dotted path of one, as what varies it, has another.
    fn names_parameter(&self, name: &str) -> bool {
        let is_of_word = |own: char| own.is_alphanumeric() || own == '_' || own == '.';
        match &self.data {
            Data::Text(text) => text.split(|own| !is_of_word(own)).any(|word| word == name),
            Data::List(items) => items.iter().any(|item| item.names_parameter(name)),
            Data::Table(table) => {
                let mut others = table.entries.iter().filter(|entry| entry.key != PARAMETERS);
                others.any(|entry| entry.node.names_parameter(name))
            }
            _ => false,
        }
    }
}

/// Refuses options that set a parameter of another name than a case with `[parameters]` gives, which nothing names once all options are `set`; a case without may be given some.
pub fn refuse_unknown_parameters(given: &Node, set: &Node, options: &[String]) -> Result<(), Fault> {
    if given.entry(PARAMETERS).is_none() {
        return Ok(());
    }
    for (index, option) in options.iter().enumerate() {
        let steps = read_option(index + 1, option)?.steps;
        if let [(PARAMETERS, _), (name, place)] = steps[..]
            && !given.has_parameter(name)
            && !set.names_parameter(name)
        {
            return Err(given.unknown_parameter(&format!("{PARAMETERS}.{name}")).at(place));
        }
    }
    Ok(())
}

/// The parameter that a dotted path means.
fn parameter(path: &str) -> Option<&str> {
    path.strip_prefix(PARAMETERS)?.strip_prefix('.')
}

#[cfg(test)]
mod tests {
    use super::super::{apply_override, parse};
    use super::refuse_unknown_parameters;

    const CASE: &str =
        "[parameters]\nmu = 0.3\nspare = 1.0\n[contact]\nfriction = \"2*mu\"\nkey = \"parameters.spare\"\n";

    #[test]
    fn a_parameter_that_is_varied_is_one_that_something_follows() {
        let varied = |path: &str| {
            let mut root = parse(CASE).unwrap();
            let (place, leaf) = (root.place, root.clone());
            root.vary(path, place, leaf).map_err(|fault| fault.into_cause().to_string())
        };
        varied("parameters.mu").unwrap();
        assert_eq!(varied("parameters.nu").unwrap_err(), "unknown parameter `parameters.nu`");
        assert_eq!(varied("parameters.spare").unwrap_err(), "nothing in the case follows `parameters.spare`");
    }

    #[test]
    fn an_option_for_a_parameter_of_another_name_is_refused() {
        let given = |text: &str, options: &[&str]| {
            let root = parse(text).unwrap();
            let mut set = root.clone();
            let options: Vec<String> = options.iter().map(|own| (*own).to_owned()).collect();
            options.iter().enumerate().for_each(|(k, own)| apply_override(&mut set, k + 1, own).unwrap());
            refuse_unknown_parameters(&root, &set, &options).map_err(|fault| fault.into_cause().to_string())
        };
        for option in ["parameters.mu=0.4", "parameters.spare=0.4", "contact.friction=0.1"] {
            given(CASE, &[option]).unwrap();
        }
        given(CASE, &["parameters.nu=0.4", "contact.friction=\"3*nu\""]).unwrap();
        given("model = \"structure\"", &["parameters.nu=0.4"]).unwrap();
        assert_eq!(given(CASE, &["parameters.nu=0.4"]).unwrap_err(), "unknown parameter `parameters.nu`");
    }
}
