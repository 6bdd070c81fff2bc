"""What lies in the archive of an FMU beside description and library, judged by schemas and readers of others."""

import io
import zipfile
from html.parser import HTMLParser
from pathlib import Path

import fmpy
import matplotlib.pyplot as plt
import numpy as np
import pytest
from conftest import EXAMPLES
from lxml import etree

SCHEMAS = Path(fmpy.__file__).parent / "schema"
# An archive of either version: every example in version 2, two of them in version 3.
ARCHIVES = [(2, name) for name in EXAMPLES] + [(3, "feeder"), (3, "funnel")]


@pytest.fixture(params=ARCHIVES, ids=lambda p: f"fmi{p[0]}-{p[1]}")
def unit(request, fmus, units):
    """An exported FMU, its version and the name of its scene."""
    version, name = request.param
    return (fmus if version == 2 else units)[name], version, name


def members(terminal):
    """Member name -> variable name of a terminal, without those below it."""
    listed = terminal.findall("TerminalMemberVariable")
    found = {m.get("memberName"): m.get("variableName") for m in listed}
    assert len(found) == len(listed)
    return found


def test_terminals_follow_the_schema_and_hold_every_variable_of_a_boundary(unit):
    path, version, name = unit
    schema = etree.XMLSchema(etree.parse(SCHEMAS / "fmi3" / "fmi3TerminalsAndIcons.xsd"))
    with zipfile.ZipFile(path) as archive:
        document = etree.fromstring(archive.read("terminalsAndIcons/terminalsAndIcons.xml"))
        schema.assertValid(document)
    terminals = {t.get("name"): t for t in document.findall("Terminals/Terminal")}
    variables = [v.name for v in fmpy.read_model_description(str(path)).modelVariables]
    of_boundaries = [v for v in variables if v.startswith("boundary.")]
    assert of_boundaries
    assert set(terminals) == {v.split(".")[1] for v in of_boundaries}
    for boundary, terminal in terminals.items():
        own = [v for v in of_boundaries if v.startswith(f"boundary.{boundary}.")]
        parts = {part.get("name"): members(part) for part in [terminal, *terminal.findall("Terminal")]}
        assert sorted(v for part in parts.values() for v in part.values()) == sorted(own)
        first, last = ("[1]", "[3]") if version == 2 else ("", "")
        where = "targetPosition" if f"boundary.{boundary}.targetPosition{first}" in own else "position"
        assert parts["pose"][f"position{first}"] == f"boundary.{boundary}.{where}{first}"
        assert parts["wrench"][f"force{last}"] == f"boundary.{boundary}.averageForce{last}"
    if name == "feeder":
        trough = members(terminals["trough"].find("Terminal[@name='joint']"))
        assert trough == {"position": "boundary.trough.displacement", "effort": "boundary.trough.slideForce"}


class Page(HTMLParser):
    """Refuses a page whose elements do not nest, and collects what it refers to and says."""

    VOID = {"meta", "img", "br", "hr", "link", "input"}

    def __init__(self):
        super().__init__()
        self.open, self.refers, self.cells, self.text = [], [], [], ""

    def handle_starttag(self, tag, attributes):
        self.refers += [value for key, value in attributes if key in ("src", "href")]
        assert tag not in ("script", "link")
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open and self.open.pop() == tag

    def handle_data(self, data):
        self.text += data
        if self.open and self.open[-1] == "td":
            self.cells.append(data)


def test_the_page_is_well_formed_complete_and_alone(unit):
    path, _, _ = unit
    description = fmpy.read_model_description(str(path))
    with zipfile.ZipFile(path) as archive:
        page = Page()
        page.feed(archive.read("documentation/index.html").decode())
        assert page.open == []
        assert page.refers == ["diagram.png"]
        assert "documentation/diagram.png" in archive.namelist()
    assert {v.name for v in description.modelVariables} <= set(page.cells)
    for part in (description.modelName, description.guid, "Validity", "Sources", "Largest internal step"):
        assert part in page.text


def test_the_pictures_show_the_scene(unit):
    path, version, _ = unit
    with zipfile.ZipFile(path) as archive:
        # FMI 3.0 knows the icon only.
        icons = ["terminalsAndIcons/icon.png"] + ["model.png"] * (version == 2)
        assert [f for f in archive.namelist() if f.endswith("model.png")] == icons[1:]
        pictures = {
            file: plt.imread(io.BytesIO(archive.read(file)))
            for file in (*icons, "documentation/diagram.png")
        }
    assert all(pictures[icon].shape[:2] == (100, 100) for icon in icons)
    assert pictures["documentation/diagram.png"].shape[:2] == (480, 480)
    for file, picture in pictures.items():
        colours = np.unique(picture.reshape(-1, picture.shape[2]), axis=0)
        assert len(colours) > 50, f"{file} is empty"


def test_licences_are_there_for_what_is_linked(fmus):
    with zipfile.ZipFile(fmus["funnel"]) as archive:
        own = archive.read("documentation/licenses/license.txt").decode()
        others = archive.read("documentation/licenses/third-party.txt").decode()
    assert "third-party.txt" in own
    for crate in ("nalgebra", "faer", "serde"):
        assert f"\n- {crate} " in others
    assert "Permission is hereby granted, free of charge" in others
