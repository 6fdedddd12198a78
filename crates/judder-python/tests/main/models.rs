//! `judder.models`, as type checkers and editors see it.

use crate::signatures::{Callable, KeywordArgument, classes};

const HEAD: &str = r#""""The models, a class each, and in it a method for every kind of analysis; `help` tells every key.

The tests write it from the declarations by which case files are read: ``JUDDER_GOLDEN=write cargo nextest run -p judder-python``.
"""

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from judder._model import Model, Result
from judder.progress import Progress
from judder.study import CaseLike

"#;

/// The stub.
pub(super) fn stub() -> String {
    let classes = classes();
    let mut names: Vec<&str> = classes.iter().map(|class| class.name.as_str()).collect();
    names.extend(["Model", "Result"]);
    names.sort_unstable();
    let names: String = names.iter().map(|name| format!("    \"{name}\",\n")).collect();
    format!("{HEAD}__all__ = [\n{names}]\n{}", classes.iter().map(class).collect::<String>())
}

fn class(class: &Callable) -> String {
    let Callable { name, parameters, methods, .. } = class;
    let parameters: String = parameters.iter().map(parameter).collect();
    let methods: String = methods.iter().map(method).collect();
    format!(
        "\nclass {name}(Model):\n    \"\"\"{}\"\"\"\n\n    def __init__(\n        self,\n        case: CaseLike | None = None,\n        *,\n        \
         set: Mapping[str, Any] | None = None,\n{parameters}    ) -> None: ...\n{methods}",
        summary(class)
    )
}

fn method(method: &Callable) -> String {
    let Callable { name, parameters, .. } = method;
    let parameters: String = parameters.iter().map(parameter).collect();
    format!(
        "    def {name}(\n        self,\n        *,\n{parameters}        threads: int | None = None,\n        \
         progress: Progress | None = None,\n    ) -> Result:\n        \"\"\"{}\"\"\"\n",
        summary(method)
    )
}

/// What it is, in a sentence.
fn summary(own: &Callable) -> String {
    let sentence = own.doc.split("\n\n").next().unwrap_or_default();
    sentence.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// One that may be left out is `None` then.
fn parameter(own: &KeywordArgument) -> String {
    let absent = if own.is_required { "" } else { " = None" };
    format!("        {}: {}{absent},\n", own.name, own.annotation)
}
