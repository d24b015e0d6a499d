package tellosimulator.scenery.room;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.world.Room;
import tellosimulator.world.Walls;

/** Tests the numbers on the floor, read from their mesh. */
class RulerTest {

  private static final String CELLS = "0123456789-xy→#|";
  private static final Comparator<Glyph> FROM_LEFT = Comparator.comparing(glyph -> -glyph.at.y());
  private static final Comparator<Glyph> FROM_ABOVE = Comparator.comparing(glyph -> -glyph.at.x());

  /** A character, or a tick, and its middle [m]. */
  private record Glyph(char character, Vec3 at) {}

  @Test
  void allNumbersAreReadAlongXInCentimeters() {
    List<Glyph> glyphs = glyphs(new Room(5, 5, 3));

    assertThat(read(glyphs, at -> at.x() < -2.1, FROM_LEFT)).isEqualTo("200100→y0-100-200");
    Comparator<Glyph> inRows = FROM_ABOVE.thenComparing(FROM_LEFT);
    assertThat(read(glyphs, at -> at.y() < -1.9 && at.x() > -2.05, inRows))
        .isEqualTo("200100→x0-100");
    assertThat(read(glyphs, at -> at.x() > 2.1 || (at.y() > 1.9 && at.x() > -2.05), inRows))
        .as("the other two edges")
        .isEmpty();
  }

  @Test
  void aLargeRoomHasFewerOfThem() {
    assertThat(read(glyphs(new Room(30, 30, 3)), at -> at.x() < -13, FROM_LEFT))
        .isEqualTo("1000500→y0-500-1000");
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1.5, 3.3, 4.4, 5, 7.9, 12.1, 24.5, 33, 61, 200})
  void numbersOfOneEdgeAreClearOfTheOther(double size) {
    List<Glyph> glyphs =
        glyphs(new Room(size, size, 3)).stream().filter(glyph -> glyph.character != '|').toList();

    double frontEdge = glyphs.stream().mapToDouble(glyph -> glyph.at.x()).min().orElseThrow();
    double sideEdge =
        glyphs.stream()
            .mapToDouble(glyph -> glyph.at.x())
            .filter(x -> x > frontEdge + 1e-6)
            .min()
            .orElse(0);
    double height = Math.min(0.19 * Ruler.step(size), 0.07 * size);
    assertThat(sideEdge - frontEdge).isGreaterThan(height);
  }

  private static String read(
      List<Glyph> glyphs, Predicate<Vec3> where, Comparator<Glyph> inThisOrder) {
    return glyphs.stream()
        .filter(glyph -> glyph.character != '|' && where.test(glyph.at))
        .sorted(inThisOrder)
        .map(glyph -> Character.toString(glyph.character))
        .collect(Collectors.joining());
  }

  /** Returns a glyph for each pair of triangles. */
  private static List<Glyph> glyphs(Room room) {
    Mesh mesh = Ruler.part(room, Walls.AUTO).mesh();
    float[] texCoords = mesh.texCoordArray();
    int[] faces = mesh.faceArray();
    List<Glyph> glyphs = new ArrayList<>();
    for (int quad = 0; quad < faces.length; quad += 18) {
      Vec3 at = Vec3.ZERO;
      double u = 0;
      double v = 0;
      for (int vertex = quad; vertex < quad + 18; vertex += 3) {
        at = at.plusScaled(mesh.position(faces[vertex]), 1 / 6.0);
        u += texCoords[2 * faces[vertex + 2]] / 6;
        v += texCoords[2 * faces[vertex + 2] + 1] / 6;
      }
      char character = CELLS.charAt((int) (4 * u) + 4 * (int) (4 * v));
      glyphs.add(new Glyph(character, rounded(at)));
      if (character != '|' && character != '→') {
        assertUpright(mesh, faces, quad);
      }
    }
    return glyphs;
  }

  /** Asserts that u grows to the right, against y, and v downwards, against x. */
  private static void assertUpright(Mesh mesh, int[] faces, int quad) {
    float[] texCoords = mesh.texCoordArray();
    Vec3 first = mesh.position(faces[quad]);
    for (int vertex = quad + 3; vertex < quad + 18; vertex += 3) {
      Vec3 moved = mesh.position(faces[vertex]).minus(first);
      float u = texCoords[2 * faces[vertex + 2]] - texCoords[2 * faces[quad + 2]];
      float v = texCoords[2 * faces[vertex + 2] + 1] - texCoords[2 * faces[quad + 2] + 1];
      assertThat(Math.signum(u)).isEqualTo(sign(-moved.y()));
      assertThat(Math.signum(v)).isEqualTo(sign(-moved.x()));
    }
  }

  private static float sign(double value) {
    return Math.abs(value) < 1e-6 ? 0 : (float) Math.signum(value);
  }

  /** Makes places in one row equal despite the mesh's single precision. */
  private static Vec3 rounded(Vec3 at) {
    return new Vec3(Math.round(at.x() * 1e4) / 1e4, Math.round(at.y() * 1e4) / 1e4, 0);
  }
}
