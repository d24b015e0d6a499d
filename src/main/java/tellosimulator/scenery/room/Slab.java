package tellosimulator.scenery.room;

import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.Falloff;
import tellosimulator.scenery.texture.ProceduralTexture;
import tellosimulator.world.Room;

/**
 * The slab below a room, and the soft shadow of the slab on the ground. They are for cameras
 * outside the room, so that the room does not appear to float. Neither is visible from inside.
 */
final class Slab {

  /** Overhang beyond the walls [m]. Decided: by eye. */
  private static final double RIM = 0.07;

  /** Thickness in metres. Decided: by eye. */
  private static final double THICKNESS = 0.11;

  /** Reach of the shadow, as a fraction of the room's shorter side. Decided: by eye. */
  private static final double REACH = 0.22;

  /** Opacity of the shadow next to the slab. Decided: by eye. */
  private static final double DARKEST = 0.55;

  /** Side length of the texture of the shadow [texels]. */
  private static final int TEXELS = 128;

  private static final Rgb TOP = Rgb.of(0xdedad3);
  private static final Rgb SIDE = Rgb.of(0xaba69d);
  private static final Rgb DARK_SIDE = Rgb.of(0x8d8981);

  private Slab() {}

  /** Returns the parts in drawing order, in the room frame. */
  static List<Part> parts(Room room) {
    double depth = room.depth() / 2 + RIM;
    double width = room.width() / 2 + RIM;
    Vec3 along = new Vec3(2 * depth, 0, 0);
    Vec3 across = new Vec3(0, 2 * width, 0);
    Vec3 up = new Vec3(0, 0, THICKNESS);
    Vec3 front = new Vec3(depth, width, -THICKNESS);
    Vec3 back = new Vec3(-depth, -width, -THICKNESS);
    MeshBuilder ends =
        new MeshBuilder()
            .quad(new Quad(front.minus(across), across, up), TextureRegion.WHOLE)
            .quad(new Quad(back.plus(across), across.times(-1), up), TextureRegion.WHOLE);
    MeshBuilder sides =
        new MeshBuilder()
            .quad(new Quad(back, along, up), TextureRegion.WHOLE)
            .quad(new Quad(front, along.times(-1), up), TextureRegion.WHOLE);
    return List.of(
        shadow(room),
        new Part(rim(room).build(), plain(TOP), Shading.UNLIT),
        new Part(ends.build(), plain(SIDE), Shading.UNLIT),
        new Part(sides.build(), plain(DARK_SIDE), Shading.UNLIT));
  }

  /** Returns the part of the slab's upper side that extends beyond the room. */
  private static MeshBuilder rim(Room room) {
    double depth = room.depth() / 2;
    double width = room.width() / 2;
    Vec3 up = new Vec3(2 * (depth + RIM), 0, 0);
    Vec3 right = new Vec3(0, -2 * width, 0);
    Vec3 wide = new Vec3(0, -RIM, 0);
    Vec3 high = new Vec3(RIM, 0, 0);
    return new MeshBuilder()
        .quad(new Quad(new Vec3(-depth - RIM, width + RIM, 0), wide, up), TextureRegion.WHOLE)
        .quad(new Quad(new Vec3(-depth - RIM, -width, 0), wide, up), TextureRegion.WHOLE)
        .quad(new Quad(new Vec3(-depth - RIM, width, 0), right, high), TextureRegion.WHOLE)
        .quad(new Quad(new Vec3(depth, width, 0), right, high), TextureRegion.WHOLE);
  }

  private static Part shadow(Room room) {
    double reach = REACH * Math.min(room.depth(), room.width());
    double depth = room.depth() + 2 * (RIM + reach);
    double width = room.width() + 2 * (RIM + reach);
    Quad ground =
        new Quad(
            new Vec3(-depth / 2, width / 2, -THICKNESS),
            new Vec3(0, -width, 0),
            new Vec3(depth, 0, 0));
    Texture texture =
        ProceduralTexture.of(
            TEXELS,
            () ->
                (x, y) -> {
                  double away = StrictMath.hypot(beyond(x, width, reach), beyond(y, depth, reach));
                  return Rgb.BLACK.argb(DARKEST * Falloff.at(1 - away));
                });
    return new Part(MeshBuilder.of(ground), texture, Shading.DECAL);
  }

  /**
   * Returns the distance of a texel from the slab along one axis, as a fraction of the reach: 0
   * below the slab, 1 at the edge of the texture.
   */
  private static double beyond(int texel, double size, double reach) {
    double edge = Math.min(texel, TEXELS - 1 - texel) / (TEXELS - 1.0) * size;
    return Math.max(0, 1 - edge / reach);
  }

  private static Texture plain(Rgb color) {
    return new Texture(1, 1, new int[] {color.argb()});
  }
}
