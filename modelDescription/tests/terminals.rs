//! Terminals and icons: the text, and every rule shown to fire alone.

use sphere_dda_model_description::terminals::{
    GraphicalRepresentation, Member, Terminal, TerminalsAndIcons,
};
use sphere_dda_model_description::{Error, Rule};

const VARIABLES: [&str; 2] = ["tray.position", "tray.force"];

fn tray() -> TerminalsAndIcons {
    let mut pose = Terminal::bus("pose", "Where it is");
    pose.members = vec![Member::signal("tray.position", "position")];
    let mut tray = Terminal::bus("tray", "A tray");
    tray.members = vec![Member::signal("tray.force", "force")];
    tray.terminals = vec![pose];
    let mut document = TerminalsAndIcons::new(vec![tray]);
    document.graphical_representation = Some(GraphicalRepresentation::square(20.0));
    document
}

/// The order of elements and the names of attributes are those of `fmi3TerminalsAndIcons.xsd`.
#[test]
fn the_text_of_a_nested_terminal() {
    let expected = r#"<?xml version="1.0" encoding="UTF-8"?>
<fmiTerminalsAndIcons fmiVersion="3.0">
  <GraphicalRepresentation>
    <CoordinateSystem x1="-10.0" y1="-10.0" x2="10.0" y2="10.0" suggestedScalingFactorTo_mm="1.0"/>
    <Icon x1="-10.0" y1="-10.0" x2="10.0" y2="10.0"/>
  </GraphicalRepresentation>
  <Terminals>
    <Terminal name="tray" matchingRule="bus" description="A tray">
      <TerminalMemberVariable variableName="tray.force" memberName="force" variableKind="signal"/>
      <Terminal name="pose" matchingRule="bus" description="Where it is">
        <TerminalMemberVariable variableName="tray.position" memberName="position" variableKind="signal"/>
      </Terminal>
    </Terminal>
  </Terminals>
</fmiTerminalsAndIcons>
"#;
    let text = tray().to_xml().unwrap();
    assert_eq!(text, expected);
    assert_eq!(TerminalsAndIcons::from_xml(&text).unwrap(), tray());
    assert_eq!(tray().validate(VARIABLES), []);
}

#[test]
fn each_breakage_is_found_and_nothing_else() {
    type Breakage = (Rule, &'static str, fn(&mut TerminalsAndIcons));
    let breakages: [Breakage; 7] = [
        (Rule::TerminalVariable, "`tray/pose`", |t| {
            t.terminals[0].terminals[0].members[0].variable_name = "gate.position".into();
        }),
        (Rule::TerminalMember, "`tray`", |t| {
            let again = Member::signal("tray.position", "force");
            t.terminals[0].members.push(again);
        }),
        (Rule::TerminalMember, "`tray`", |t| {
            t.terminals[0].members[0].member_name = None;
        }),
        (Rule::TerminalUnique, "`tray/pose`", |t| {
            let again = t.terminals[0].terminals[0].clone();
            t.terminals[0].terminals.push(again);
        }),
        (Rule::RequiredAttribute, "Terminal", |t| {
            t.terminals[0].name.clear();
        }),
        (Rule::Drawing, "CoordinateSystem", |t| {
            t.graphical_representation = Some(GraphicalRepresentation {
                icon: None,
                ..GraphicalRepresentation::square(0.0)
            });
        }),
        (Rule::Drawing, "Icon", |t| {
            let mut area = GraphicalRepresentation::square(20.0);
            area.icon.as_mut().unwrap().x2 = f64::NAN;
            t.graphical_representation = Some(area);
        }),
    ];
    for (rule, place, break_it) in breakages {
        let mut document = tray();
        break_it(&mut document);
        let findings = document.validate(VARIABLES);
        assert_eq!(findings.len(), 1, "{rule:?}: {findings:#?}");
        assert_eq!(findings[0].rule, rule);
        assert!(findings[0].place.contains(place), "{}", findings[0]);
    }
}

#[test]
fn members_of_a_sequence_need_no_names() {
    let mut document = tray();
    document.terminals[0].matching_rule = "sequence".into();
    document.terminals[0].members[0].member_name = None;
    assert_eq!(document.validate(VARIABLES), []);
}

#[test]
fn what_is_not_a_terminals_file_is_refused() {
    let read = TerminalsAndIcons::from_xml;
    let wrong_version = tray().to_xml().unwrap().replace("\"3.0\"", "\"2.0\"");
    assert!(matches!(read(&wrong_version), Err(Error::Version { .. })));
    let nameless = tray().to_xml().unwrap().replace("name=\"tray\" ", "");
    assert!(matches!(read(&nameless), Err(Error::Content { .. })));
    let other = "<fmiModelDescription fmiVersion=\"3.0\"/>";
    assert!(matches!(read(other), Err(Error::Root { .. })));
}
