"""Every public name of the package."""

import inspect

import judder

MODULES = [
    judder,
    judder.contact,
    judder.distributed,
    judder.errors,
    judder.models,
    judder.oscillator,
    judder.plot,
    judder.programs,
    judder.progress,
    judder.sliding,
    judder.study,
    judder.sweep,
]


def public():
    """Every public name of the modules, with its object."""
    for module in MODULES:
        for name in module.__all__:
            yield f"{module.__name__}.{name}", getattr(module, name)


def callables():
    """Every public function, class and method with its class, which is None of a function and of a class itself; each once."""
    seen = set()
    for name, item in public():
        if id(item) in seen or not getattr(item, "__module__", "").startswith("judder"):
            continue
        seen.add(id(item))
        if inspect.isroutine(item):
            yield name, item, None
        elif inspect.isclass(item) and not issubclass(item, BaseException | dict):
            if "__init__" in vars(item) or "_new" in vars(item):
                yield name, item, None
            owners = [owner for owner in item.__mro__ if owner.__module__.startswith("judder")]
            members = {member for owner in owners for member, value in vars(owner).items() if is_method(value) and not member.startswith("_")}
            yield from ((f"{name}.{member}", getattr(item, member), item) for member in sorted(members))


def is_method(value):
    """Whether a member of a class is called."""
    return inspect.isroutine(value) or isinstance(value, staticmethod | classmethod)
