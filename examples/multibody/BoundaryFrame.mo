model BoundaryFrame
  "Wires a MultiBody frame to a boundary with input = \"world_pose\" of an FMU of sphere-dda"
  extends Modelica.Mechanics.MultiBody.Interfaces.PartialOneFrame_a;
  import Modelica.Mechanics.MultiBody.Frames;

  parameter Frames.Quaternions.Orientation Q_scene = Frames.Quaternions.nullRotation()
    "Orientation {x,y,z,w} that frame_a has where the scene draws the boundary";

  Modelica.Blocks.Interfaces.RealOutput position[3](each final unit="m")
    "To boundary.NAME.targetPosition"
    annotation (Placement(transformation(extent={{100,50},{120,70}})));
  Modelica.Blocks.Interfaces.RealOutput orientation[4](each final unit="1")
    "w, x, y, z; to boundary.NAME.targetOrientation"
    annotation (Placement(transformation(extent={{100,10},{120,30}})));
  Modelica.Blocks.Interfaces.RealInput force[3](each final unit="N")
    "From boundary.NAME.averageForce: of the spheres on the boundary, world axes"
    annotation (Placement(transformation(extent={{120,-40},{100,-20}})));
  Modelica.Blocks.Interfaces.RealInput torque[3](each final unit="N.m")
    "From boundary.NAME.averageTorque: about the origin of frame_a, world axes"
    annotation (Placement(transformation(extent={{120,-80},{100,-60}})));
protected
  Frames.Quaternions.Orientation Q "Rotation from the scene's placement, {x,y,z,w}";
equation
  position = frame_a.r_0;
  // R.T takes the coordinates of a vector from the world to the frame; the quaternion of the same rotation turns the world's
  // axes into the frame's.
  Q = Frames.Quaternions.from_T(transpose(Frames.Quaternions.to_T(Q_scene))*frame_a.R.T);
  orientation = {Q[4], Q[1], Q[2], Q[3]};
  // Cut forces count what the frame gives to this component, so those on the body change their sign.
  frame_a.f = -Frames.resolve2(frame_a.R, force);
  frame_a.t = -Frames.resolve2(frame_a.R, torque);
  annotation (
    Icon(graphics={
      Rectangle(extent={{-100,100},{100,-100}}),
      Text(extent={{-150,140},{150,100}}, textString="%name")}),
    uses(Modelica(version="4.0.0")));
end BoundaryFrame;
