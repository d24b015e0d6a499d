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

/**
 * The outline that highlights the frame of a gate, without its posts. It surrounds the frame at a
 * small distance.
 */
final class GateOutline {

  /**
   * Distance of the outline from the frame [m]. Decided: the outline is visibly in front of the
   * frame; without a distance, their surfaces would coincide.
   */
  private static final double MARGIN = 0.012;

  /** Rotates a shape that extends along z so that it extends along x. */
  static final Attitude ALONG_X = Attitude.tiltedTo(new Vec3(1, 0, 0));

  private static final int SIDES = 48;

  private GateOutline() {}

  /** Creates the outline of a gate, in the gate's frame. */
  static Part of(Shape.Gate gate, Texture texture) {
    return gate.match(ring -> of(ring, texture), frame -> of(frame, texture));
  }

  private static Part of(Shape.Ring ring, Texture texture) {
    double tube = ring.tube() / 2;
    Mesh lying = LatheMesh.torus(ring.radius() + tube, tube + MARGIN, SIDES);
    Pose upright = new Pose(new Vec3(0, 0, ring.middle()), ALONG_X);
    Part part = new Part(lying, texture, Shading.TRANSLUCENT);
    return MeshBatch.of(List.of(new Instance(part, upright))).get(0);
  }

  private static Part of(Shape.Frame frame, Texture texture) {
    MeshBuilder mesh = new MeshBuilder();
    for (Shape.Beam beam : frame.beams()) {
      double bottom = Math.max(beam.base().z(), frame.post());
      double top = beam.base().z() + beam.size().z();
      Vec3 middle = beam.base().withZ((bottom + top) / 2);
      Vec3 size = beam.size().withZ(top - bottom);
      mesh.box(middle, size.plus(new Vec3(2 * MARGIN, 2 * MARGIN, 2 * MARGIN)));
    }
    return new Part(mesh.build(), texture, Shading.TRANSLUCENT);
  }
}
