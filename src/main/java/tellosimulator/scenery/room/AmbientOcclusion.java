package tellosimulator.scenery.room;

import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.Falloff;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/**
 * The ambient occlusion where floor, walls and ceiling meet. It is baked into the textures of walls
 * and ceiling; on the floor, whose texture repeats, strips along its edges lie over it. Either
 * costs next to nothing when the room changes, and is the same in each renderer.
 */
final class AmbientOcclusion {

  /** How far the shade reaches from an edge [m]. Decided: by eye. */
  private static final double REACH = 0.9;

  /** The same, as a part of a face's shorter edge. */
  private static final double LARGEST_PART = 0.4;

  /**
   * How far it reaches down a wall, compared with that. Decided: by eye; people look into the room
   * from above, through the ceiling.
   */
  private static final double BELOW_CEILING = 0.5;

  /** Opacity right at an edge. Decided: by eye. */
  private static final double DARKEST = 0.22;

  /** Warm, as light that wood and plaster reflect. Decided: by eye. */
  private static final Rgb SHADE = Rgb.of(0x1c1813);

  private static final Texture TEXTURE = Falloff.texture(SHADE, DARKEST);

  private AmbientOcclusion() {}

  /** Four strips, which multiply in the corners of the floor, room frame. */
  static Part onFloor(Room room) {
    Face floor = Face.of(room, Surface.FLOOR);
    Vec3 right = floor.right().times(floor.width());
    Vec3 up = floor.up().times(floor.height());
    Vec3 inwards = floor.right().times(reach(floor));
    Vec3 upwards = floor.up().times(reach(floor));
    Vec3 corner = floor.quad().corner();
    Vec3 opposite = corner.plus(right).plus(up);
    MeshBuilder strips =
        new MeshBuilder()
            .quad(new Quad(corner, right, upwards), Falloff.REGION)
            .quad(new Quad(corner.plus(right), up, inwards.times(-1)), Falloff.REGION)
            .quad(new Quad(opposite, right.times(-1), upwards.times(-1)), Falloff.REGION)
            .quad(new Quad(corner.plus(up), up.times(-1), inwards), Falloff.REGION);
    return new Part(strips.build(), TEXTURE, Shading.DECAL);
  }

  /**
   * A colour at a place on a wall or the ceiling.
   *
   * @param across from the left edge to the right one, 0 to 1
   * @param up from the lower edge to the upper one, 0 to 1
   */
  static Rgb shaded(Rgb color, Face face, double across, double up) {
    double left = Math.min(across, 1 - across) * face.width();
    double low = up * face.height();
    double high = (1 - up) * face.height() / BELOW_CEILING;
    Rgb shaded = color;
    for (double distance : new double[] {left, low, high}) {
      shaded = shaded.towards(SHADE, DARKEST * Falloff.at(1 - distance / reach(face)));
    }
    return shaded;
  }

  private static double reach(Face face) {
    return Math.min(REACH, LARGEST_PART * Math.min(face.width(), face.height()));
  }
}
