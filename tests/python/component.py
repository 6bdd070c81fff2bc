"""An importer of components of WebAssembly by the draft FMI-LS-WASM, on wasmtime."""

import xml.etree.ElementTree as ET
import zipfile

from wasmtime import Engine, Store
from wasmtime.component import Component, Linker

PLACE = "binaries/wasm32-wasip2/{}.wasm"
INTERFACE, RESOURCE = "fmi:fmi3/co-simulation@3.0.0", "co-simulation-instance"


class Failed(Exception):
    """A call that was refused, with what the component said."""


class Module:
    """The component of an FMU: compiled once, with as many instances as one likes."""

    def __init__(self, fmu):
        with zipfile.ZipFile(fmu) as archive:
            root = ET.fromstring(archive.read("modelDescription.xml"))
            code = archive.read(PLACE.format(root.find("CoSimulation").get("modelIdentifier")))
        self.size = len(code)
        self.token = root.get("instantiationToken")
        self.references = {
            own.get("name"): int(own.get("valueReference")) for own in root.find("ModelVariables")
        }
        self.engine = Engine()
        self.component = Component(self.engine, code)

    def instantiate(self, **options):
        return Fmu(self, **options)


class Fmu:
    """An instance: methods have the names of WIT, with `_` for `-`."""

    def __init__(self, module, update=None, token=None, early_return=False):
        self.module, self.messages = module, []
        self.store = Store(module.engine)
        linker = Linker(module.engine)
        with linker.root() as root:
            with root.add_instance("fmi:fmi3/callbacks@3.0.0") as callbacks:
                callbacks.add_func("log-message", lambda _, *line: self.messages.append(line))
            with root.add_instance("fmi:fmi3/intermediate-update-callbacks@3.0.0") as updates:
                updates.add_func("intermediate-update", lambda _, *at: update(*at))
        self.instance = linker.instantiate(self.store, module.component)
        self.interface = self.instance.get_export_index(self.store, INTERFACE)
        make = self.function(f"[static]{RESOURCE}.instantiate-co-simulation")
        given = token or module.token
        self.handle = make("one", given, "", False, False, False, early_return, [])
        if self.handle is None:
            raise Failed(self.messages)

    def function(self, name):
        index = self.instance.get_export_index(self.store, name, self.interface)
        found = self.instance.get_func(self.store, index)

        def call(*arguments):
            value = found(self.store, *arguments)
            found.post_return(self.store)
            return value

        return call

    def __getattr__(self, name):
        method = self.function(f"[method]{RESOURCE}.{name.replace('_', '-')}")

        def call(*arguments):
            answer = method(self.handle, *arguments)
            tag = getattr(answer, "tag", answer)
            if tag in ("discard", "error", "fatal", "err"):
                raise Failed(name, answer, self.messages)
            return answer.payload if hasattr(answer, "payload") else answer

        setattr(self, name, call)
        return call

    def start(self, stop=None):
        self.enter_initialization_mode(None, 0.0, stop)
        self.exit_initialization_mode()

    def get(self, *names):
        return self.get_float64([self.module.references[name] for name in names])

    def set(self, **values):
        self.set_float64([self.module.references[name] for name in values], list(values.values()))
