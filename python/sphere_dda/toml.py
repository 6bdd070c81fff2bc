"""A dict as TOML: top-level dicts as tables, lists of dicts as arrays of tables, all else in one line each."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping
from typing import Any


def document(data: Mapping[str, Any]) -> str:
    """The text of a TOML document. Keys whose value is None are left out.

    Raises:
        TypeError: a value that TOML has no type for, by its key.
    """
    lines, tables = [], []
    for key, value in data.items():
        if isinstance(value, Mapping):
            tables += ["", f"[{_key(key)}]", *_lines(value, key)]
        elif isinstance(value, (list, tuple)) and value and all(isinstance(one, Mapping) for one in value):
            for k, one in enumerate(value):
                tables += ["", f"[[{_key(key)}]]", *_lines(one, f"{key}[{k}]")]
        elif value is not None:
            lines.append(f"{_key(key)} = {_value(value, key)}")
    return "\n".join([*lines, *tables]).lstrip("\n") + "\n"


def _lines(table: Mapping[str, Any], path: str) -> list[str]:
    return [f"{_key(key)} = {_value(value, f'{path}.{key}')}" for key, value in table.items() if value is not None]


def _key(key: str) -> str:
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else _text(key)


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: Any, path: str) -> str:
    if hasattr(value, "tolist"):  # numpy
        value = value.tolist()
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return _text(os.fspath(value))
    if isinstance(value, Mapping):
        return "{ " + ", ".join(_lines(value, path)) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(one, f"{path}[{k}]") for k, one in enumerate(value)) + "]"
    raise TypeError(f"{path}: found {type(value).__name__}, expected a number, text, bool, list, array or dict")
