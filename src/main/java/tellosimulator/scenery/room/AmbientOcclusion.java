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
 * The ambient occlusion where the floor, walls and ceiling of a calm room ({@code Walls.AUTO})
 * meet. It is baked into the textures of the walls and the ceiling. The texture of the floor
 * repeats, so strips of shade are drawn along the edges of the floor instead. Both methods add
 * almost no cost when the room changes, and look the same in every renderer.
 */
final class AmbientOcclusion {

  /** Reach of the shade from an edge [m]. Decided: by eye. */
  private static final double REACH = 0.9;

  /** Maximum reach, as a fraction of the shorter side of a face. */
  private static final double LARGEST_PART = 0.4;

  /**
   * Reach downwards from the ceiling, as a fraction of the normal reach. Decided: by eye; it is
   * shorter because people look into the room from above, through the ceiling.
   */
  private static final double BELOW_CEILING = 0.5;

  /**
   * Reach on the floor, as a fraction of the normal reach. Decided: by eye; the wider the strips,
   * the longer a camera takes to render them.
   */
  private static final double ON_FLOOR = 0.4;

  /** Opacity right at an edge. Decided: by eye. */
  private static final double DARKEST = 0.22;

  /**
   * Colour of the shade: warm, like light that is reflected by wood and plaster. Decided: by eye.
   */
  private static final Rgb SHADE = Rgb.of(0x1c1813);

  private static final Texture TEXTURE = Falloff.texture(SHADE, DARKEST);

  private AmbientOcclusion() {}

  /**
   * Returns four strips along the edges of the floor, in the room frame. They overlap in the
   * corners, which are therefore darker.
   */
  static Part onFloor(Room room) {
    Face floor = Face.of(room, Surface.FLOOR);
    Vec3 right = floor.right().times(floor.width());
    Vec3 up = floor.up().times(floor.height());
    Vec3 inwards = floor.right().times(ON_FLOOR * reach(floor));
    Vec3 upwards = floor.up().times(ON_FLOOR * reach(floor));
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
   * Returns the shaded colour at a place on a wall or the ceiling.
   *
   * @param across position from the left edge to the right one, 0 to 1
   * @param up position from the lower edge to the upper one, 0 to 1
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
