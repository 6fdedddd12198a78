"""The models, a class each, and in it a method for every kind of analysis: all that a case file can say, as keyword arguments.

They are made of the declarations by which case files are read; what type checkers see of them stands in ``models.pyi``.
"""

from judder import _arguments
from judder._declared import classes
from judder._model import Model, Result

_classes = classes()
globals().update(_classes)
__all__ = sorted([*_classes, Model.__name__, Result.__name__])

_arguments.checked(globals())
