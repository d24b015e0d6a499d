package tellosimulator.scenery.drone;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import tellosimulator.extension.BoardLights;
import tellosimulator.extension.MatrixPicture;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;

/**
 * The extension board on top of a RoboMaster TT: its case, its lamp, and a panel with the dot
 * matrix. All positions are in the body frame [m]. The most recent parts are cached, so equal
 * lights give the same parts. Thread-safe.
 *
 * <p>Assumed: sizes and positions, by eye, from pictures. Decided: the panel shows the same image
 * on its back, for people who stand behind the drone; a real panel shows it only on its front.
 */
public final class ExtensionBoard {

  /**
   * Maximum number of cached parts of each kind. Decided: a scrolling text may have more images,
   * but it changes slowly.
   */
  private static final int MOST = 64;

  private static final Vec3 CASE = new Vec3(-0.003, 0, 0.04);
  private static final Vec3 CASE_SIZE = new Vec3(0.034, 0.024, 0.012);
  private static final Vec3 PANEL = new Vec3(0.0125, 0, 0.06);
  private static final Vec3 PANEL_SIZE = new Vec3(0.003, 0.03, 0.03);
  private static final double MATRIX = 0.027;
  private static final Vec3 LAMP = new Vec3(-0.01, 0, 0.0475);
  private static final double LAMP_RADIUS = 0.0055;

  private static final Rgb CASE_COLOR = Rgb.of(0x24262b);
  private static final Rgb LAMP_OFF = Rgb.of(0x6b7076);
  private static final Rgb BETWEEN_DOTS = Rgb.of(0x111215);
  private static final Rgb DOT_OFF = Rgb.of(0x2b2e34);
  private static final Rgb RED = Rgb.of(0xff3020);
  private static final Rgb BLUE = Rgb.of(0x2f7bff);
  private static final Rgb PURPLE = Rgb.of(0xc04dff);

  /** Minimum brightness of a lit dot. Decided: still visible. */
  private static final double DIMMEST = 0.2;

  /** Side length of the square that a dot and its surroundings occupy [texels]. */
  private static final int CELL = 8;

  private static final int TEXELS = CELL * MatrixPicture.SIZE;

  /** Parts that all boards share; created together with the first TT. */
  private static final class Shared {
    static final Part BODY =
        new Part(
            new MeshBuilder().box(CASE, CASE_SIZE).box(PANEL, PANEL_SIZE).build(),
            plain(CASE_COLOR),
            Shading.GLOSSY);
    static final Mesh LAMP_MESH = StatusLamp.ball(LAMP, LAMP_RADIUS);
    static final Mesh MATRIX_MESH = matrixMesh();
  }

  private record Dots(MatrixPicture picture, int brightness) {}

  private final Map<Integer, Part> lamps = new Latest<>();
  private final Map<Dots, Part> matrices = new Latest<>();

  /** Returns the parts of a drone's board as they look at the time of the given state. */
  public List<Part> parts(DroneState state) {
    BoardLights lights = state.lights();
    Dots dots = new Dots(lights.picture(state.time()), lights.brightness());
    return List.of(
        Shared.BODY,
        kept(lamps, lights.lampRgb(state.time()), ExtensionBoard::lamp),
        kept(matrices, dots, ExtensionBoard::matrix));
  }

  private static <K> Part kept(Map<K, Part> parts, K look, Function<K, Part> make) {
    synchronized (parts) {
      Part known = parts.get(look);
      if (known == null) {
        known = make.apply(look);
        parts.put(look, known);
      }
      return known;
    }
  }

  private static Part lamp(int rgb) {
    Rgb color = Rgb.of(rgb);
    double light = Math.max(color.red(), Math.max(color.green(), color.blue())) / 255.0;
    Rgb full = light == 0 ? color : brightened(color, 1 / light);
    return new Part(Shared.LAMP_MESH, plain(LAMP_OFF.towards(full, light)), Shading.UNLIT);
  }

  private static Rgb brightened(Rgb color, double factor) {
    return new Rgb(
        (int) Math.round(color.red() * factor),
        (int) Math.round(color.green() * factor),
        (int) Math.round(color.blue() * factor));
  }

  private static Part matrix(Dots dots) {
    int[] argb = new int[TEXELS * TEXELS];
    Arrays.setAll(
        argb,
        i -> {
          int row = i / TEXELS;
          int column = i % TEXELS;
          double down = row % CELL + 0.5 - CELL / 2.0;
          double right = column % CELL + 0.5 - CELL / 2.0;
          double within = CELL * 0.42 - Math.sqrt(down * down + right * right);
          double covered = Math.max(0, Math.min(1, within + 0.5));
          return BETWEEN_DOTS.towards(color(dots, row / CELL, column / CELL), covered).argb();
        });
    Texture texture = new Texture(TEXELS, TEXELS, argb);
    return new Part(Shared.MATRIX_MESH, texture, Shading.UNLIT);
  }

  private static Rgb color(Dots dots, int row, int column) {
    MatrixPicture picture = dots.picture;
    if (dots.brightness == 0 || !picture.lit(row, column)) {
      return DOT_OFF;
    }
    boolean red = picture.red(row, column);
    Rgb lit = red && picture.blue(row, column) ? PURPLE : red ? RED : BLUE;
    double light = DIMMEST + (1 - DIMMEST) * dots.brightness / BoardLights.BRIGHTEST;
    return DOT_OFF.towards(lit, light);
  }

  /** Creates two squares: one in front of the panel and one behind it. */
  private static Mesh matrixMesh() {
    double half = MATRIX / 2;
    double off = PANEL_SIZE.x() / 2 + 0.0002;
    Vec3 up = new Vec3(0, 0, MATRIX);
    Quad ahead = new Quad(PANEL.plus(new Vec3(off, -half, -half)), new Vec3(0, MATRIX, 0), up);
    Quad behind = new Quad(PANEL.plus(new Vec3(-off, half, -half)), new Vec3(0, -MATRIX, 0), up);
    return new MeshBuilder()
        .quad(ahead, TextureRegion.WHOLE)
        .quad(behind, TextureRegion.WHOLE)
        .build();
  }

  private static Texture plain(Rgb color) {
    return new Texture(1, 1, new int[] {color.argb()});
  }

  /** An LRU cache. Not thread-safe. */
  private static final class Latest<K> extends LinkedHashMap<K, Part> {

    private static final long serialVersionUID = 1;

    Latest() {
      super(16, 0.75f, true);
    }

    @Override
    protected boolean removeEldestEntry(Map.Entry<K, Part> eldest) {
      return size() > MOST;
    }
  }
}
