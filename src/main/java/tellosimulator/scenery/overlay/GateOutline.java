package tellosimulator.scenery.overlay;

import java.util.List;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBatch;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.world.Shape;

/** What marks the frame of a gate, without its posts: all around it, a little larger. */
final class GateOutline {

  /** How far it stands off the frame [m]. Decided: to be seen around what is one with the frame. */
  private static final double MARGIN = 0.012;

  /** Turns what stands on the z axis so that it lies along x. */
  static final Attitude ALONG_X = Attitude.tiltedTo(new Vec3(1, 0, 0));

  private static final int SIDES = 48;

  private GateOutline() {}

  /** Around the frame, in the gate's frame. */
  static Part of(Shape.Gate gate, Texture texture) {
    if (gate instanceof Shape.Ring ring) {
      double tube = ring.tube() / 2;
      Mesh lying = LatheMesh.torus(ring.radius() + tube, tube + MARGIN, SIDES);
      Pose upright = new Pose(new Vec3(0, 0, ring.middle()), ALONG_X);
      Part part = new Part(lying, texture, Shading.TRANSLUCENT);
      return MeshBatch.of(List.of(new Instance(part, upright))).get(0);
    }
    return new Part(of((Shape.Frame) gate), texture, Shading.TRANSLUCENT);
  }

  private static Mesh of(Shape.Frame frame) {
    MeshBuilder mesh = new MeshBuilder();
    for (Shape.Beam beam : frame.beams()) {
      double bottom = Math.max(beam.base().z(), frame.post());
      double top = beam.base().z() + beam.size().z();
      Vec3 middle = beam.base().withZ((bottom + top) / 2);
      Vec3 size = beam.size().withZ(top - bottom);
      mesh.box(middle, size.plus(new Vec3(2 * MARGIN, 2 * MARGIN, 2 * MARGIN)));
    }
    return mesh.build();
  }
}
