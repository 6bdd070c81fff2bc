"""What lies in the archive of an FMU beside description and library, judged by schemas and readers of others."""

import zipfile
from pathlib import Path

import fmpy
import pytest
from conftest import EXAMPLES
from lxml import etree

SCHEMAS = Path(fmpy.__file__).parent / "schema"


def members(terminal):
    """Member name -> variable name of a terminal and of all below it."""
    found = {m.get("memberName"): m.get("variableName") for m in terminal.findall("TerminalMemberVariable")}
    for below in terminal.findall("Terminal"):
        found |= members(below)
    return found


@pytest.mark.parametrize("name", EXAMPLES)
def test_terminals_follow_the_schema_and_hold_every_variable_of_a_boundary(fmus, name):
    schema = etree.XMLSchema(etree.parse(SCHEMAS / "fmi3" / "fmi3TerminalsAndIcons.xsd"))
    with zipfile.ZipFile(fmus[name]) as archive:
        document = etree.fromstring(archive.read("terminalsAndIcons/terminalsAndIcons.xml"))
        schema.assertValid(document)
    terminals = {t.get("name"): t for t in document.findall("Terminals/Terminal")}
    variables = [v.name for v in fmpy.read_model_description(str(fmus[name])).modelVariables]
    of_boundaries = [v for v in variables if v.startswith("boundary.")]
    assert of_boundaries
    assert set(terminals) == {v.split(".")[1] for v in of_boundaries}
    for boundary, terminal in terminals.items():
        prefix = f"boundary.{boundary}."
        wanted = {v.removeprefix(prefix): v for v in of_boundaries if v.startswith(prefix)}
        assert members(terminal) == wanted
        parts = {part.get("name"): members(part) for part in terminal.findall("Terminal")}
        assert "position[1]" in parts["pose"] and "averageForce[3]" in parts["wrench"]
    if name == "feeder":
        assert "displacement" in members(terminals["trough"].find("Terminal[@name='pose']"))
