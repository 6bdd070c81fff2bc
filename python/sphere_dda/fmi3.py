"""An FMU instance: the functions of FMI 3.0 for co-simulation by ctypes, with the log's messages as exceptions."""

from __future__ import annotations

import os
import sys
import threading
import warnings
from ctypes import CDLL, CFUNCTYPE, POINTER, byref, c_bool, c_char_p, c_double, c_int, c_size_t, c_ubyte, c_uint32, c_void_p
from ctypes import create_string_buffer, string_at
from pathlib import Path
from typing import Any

import numpy as np

from .description import Variable
from .errors import SimulationError, SimulationWarning

ENDED = "the simulation has ended: it was closed, or its recording is complete; make a new one"
_OK, _WARNING, _DISCARD = 0, 1, 2
_Log = CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)

#: Type of a variable -> name of its functions and type of its numbers in C.
_NUMBERS = {
    "Float64": ("Float64", np.float64), "Int32": ("Int32", np.int32), "Int64": ("Int64", np.int64),
    "Enumeration": ("Int64", np.int64), "Boolean": ("Boolean", np.bool_),
}

_ARGUMENTS: dict[str, list[Any]] = {
    "EnterInitializationMode": [c_bool, c_double, c_double, c_bool, c_double],
    "ExitInitializationMode": [],
    "Terminate": [],
    "DoStep": [c_double, c_double, c_bool, POINTER(c_bool), POINTER(c_bool), POINTER(c_bool), POINTER(c_double)],
    "GetFMUState": [POINTER(c_void_p)],
    "SetFMUState": [c_void_p],
    "FreeFMUState": [POINTER(c_void_p)],
    "SerializedFMUStateSize": [c_void_p, POINTER(c_size_t)],
    "SerializeFMUState": [c_void_p, c_void_p, c_size_t],
    "DeserializeFMUState": [c_char_p, c_size_t, POINTER(c_void_p)],
    "GetString": [POINTER(c_uint32), c_size_t, POINTER(c_char_p), c_size_t],
    "SetString": [POINTER(c_uint32), c_size_t, POINTER(c_char_p), c_size_t],
    "GetBinary": [POINTER(c_uint32), c_size_t, POINTER(c_size_t), POINTER(POINTER(c_ubyte)), c_size_t],
    **{f"{verb}{kind}": [POINTER(c_uint32), c_size_t, c_void_p, c_size_t] for verb in ("Get", "Set") for kind, _ in _NUMBERS.values()},
}


class Library:
    """The functions of the library, loaded once in a process."""

    _loaded: dict[Path, Library] = {}
    _lock = threading.Lock()

    def __init__(self, path: Path):
        self._library = CDLL(os.fspath(path))
        self.instantiate = self._library.fmi3InstantiateCoSimulation
        self.instantiate.restype = c_void_p
        self.instantiate.argtypes = [
            c_char_p, c_char_p, c_char_p, c_bool, c_bool, c_bool, c_bool, c_void_p, c_size_t, c_void_p, _Log, c_void_p
        ]
        self.free = self._library.fmi3FreeInstance
        self.free.restype, self.free.argtypes = None, [c_void_p]
        self.calls = {}
        for name, arguments in _ARGUMENTS.items():
            function = getattr(self._library, f"fmi3{name}")
            function.restype, function.argtypes = c_int, [c_void_p, *arguments]
            self.calls[name] = function

    @classmethod
    def load(cls, path: Path) -> Library:
        """The library at `path`."""
        with cls._lock:
            if path not in cls._loaded:
                cls._loaded[path] = cls(path)
            return cls._loaded[path]


class Instance:
    """An instance of the FMU. Every call that is not answered by OK or Warning raises a SimulationError."""

    def __init__(self, library: Path, token: str, resources: Path, name: str):
        self._library = Library.load(library)
        self._messages: list[str] = []
        #: Calls so far, by name.
        self.calls = dict.fromkeys(_ARGUMENTS, 0)
        messages = self._messages
        # ctypes does not keep the callback alive.
        self._log = _Log(lambda _, __, ___, text: messages.append(text.decode(errors="replace")))
        folder = os.path.join(os.fspath(resources), "")
        self._instance = self._library.instantiate(
            name.encode(), token.encode(), os.fsencode(folder), False, False, False, False, None, 0, None, self._log, None
        )
        if not self._instance:
            raise SimulationError(self._told() or "the FMU was not instantiated, and its log does not say why")
        self._flags = [byref(c_bool()) for _ in range(3)]
        self._reached = c_double()

    def call(self, name: str, *arguments: Any) -> None:
        """Calls `fmi3<name>`."""
        if not self._instance:
            raise SimulationError(ENDED)
        self.calls[name] += 1
        status = self._library.calls[name](self._instance, *arguments)
        if status == _OK and not self._messages:
            return
        text = self._told() or f"fmi3{name} failed"
        if status > _WARNING:
            raise SimulationError(text, "discard" if status == _DISCARD else "error")
        _warn(text)

    def _told(self) -> str:
        text = "\n".join(self._messages)
        self._messages.clear()
        return text

    def free(self) -> None:
        """Frees the instance; does nothing the second time."""
        if self._instance:
            self._library.free(self._instance)
            self._instance = None

    def step(self, time: float, length: float) -> float:
        """Takes a communication step; the time that it has reached [s]."""
        self.call("DoStep", time, length, False, *self._flags, byref(self._reached))
        return self._reached.value

    def get(self, variable: Variable, out: np.ndarray | None = None) -> Any:
        """The value of a variable: a number, text, bytes, or an array of its shape, written to `out` if there is one."""
        reference = byref(c_uint32(variable.reference))
        if variable.type == "String":
            text = c_char_p()
            self.call("GetString", reference, 1, byref(text), 1)
            return (text.value or b"").decode()
        if variable.type == "Binary":
            size, data = c_size_t(), POINTER(c_ubyte)()
            self.call("GetBinary", reference, 1, byref(size), byref(data), 1)
            return string_at(data, size.value)
        kind, number = _NUMBERS[variable.type]
        array = np.empty(variable.shape, number) if out is None else out
        self.call(f"Get{kind}", reference, 1, array.ctypes.data, array.size)
        return array if variable.shape else array.item()

    def set(self, variable: Variable, value: Any) -> None:
        """Sets a variable; numbers must have its shape."""
        reference = byref(c_uint32(variable.reference))
        if variable.type == "String":
            text = c_char_p(os.fspath(value).encode())
            return self.call("SetString", reference, 1, byref(text), 1)
        if variable.type == "Binary":
            raise SimulationError(f"{variable.name}: cannot be set")
        kind, number = _NUMBERS[variable.type]
        if variable.choices and isinstance(value, str):
            if value not in variable.choices:
                raise SimulationError(f"{variable.name}: found `{value}`, expected one of {', '.join(variable.choices)}")
            value = variable.choices[value]
        try:
            array = np.asarray(value)
            plain: np.ndarray = np.array(array, dtype=number, order="C")
            # A count of 2.5 or a text is no value of this variable.
            fits = array.dtype.kind in "biuf" and (number is np.float64 or bool((plain == array).all()))
        except (TypeError, ValueError, OverflowError):
            fits = False
        if not fits or plain.shape != variable.shape:
            shape = f"an array of shape {variable.shape}" if variable.shape else "one number"
            unit = f" [{variable.unit}]" if variable.unit else ""
            raise SimulationError(f"{variable.name}: found {value!r}, expected {shape} of type {variable.type}{unit}")
        self.call(f"Set{kind}", reference, 1, plain.ctypes.data, plain.size)

    def save(self) -> bytes:
        """The state as bytes."""
        state, size = c_void_p(), c_size_t()
        self.call("GetFMUState", byref(state))
        try:
            self.call("SerializedFMUStateSize", state, byref(size))
            data = create_string_buffer(size.value)
            self.call("SerializeFMUState", state, data, size.value)
        finally:
            self.call("FreeFMUState", byref(state))
        return data.raw

    def restore(self, data: bytes) -> None:
        """Restores a state."""
        state = c_void_p()
        self.call("DeserializeFMUState", data, len(data), byref(state))
        try:
            self.call("SetFMUState", state)
        finally:
            self.call("FreeFMUState", byref(state))


def _warn(text: str) -> None:
    """Warns at the line that called the package."""
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    warnings.warn(text, SimulationWarning, stacklevel=level)
