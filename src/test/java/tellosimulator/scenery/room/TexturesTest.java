package tellosimulator.scenery.room;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.function.IntBinaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.ProceduralTexture;

class TexturesTest {

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          bricks,    986615857
          hexagons,  1925357995
          boards,    -1284615537
          triangles, -1934650623
          panels,    -2024680950
          parquet,   1110434159
          """)
  void texturesAreTheSameOnEveryMachine(String name, int hash) {
    assertThat(Arrays.hashCode(texture(name).argbArray())).isEqualTo(hash);
  }

  @ParameterizedTest
  @MethodSource("all")
  void theyRepeatWithoutASeam(Texture texture) {
    int size = texture.width();

    assertThat(step(size, (x, y) -> texture.argb(x, y), size - 1))
        .isLessThanOrEqualTo(largestStepWithin(size, (x, y) -> texture.argb(x, y)));
    assertThat(step(size, (x, y) -> texture.argb(y, x), size - 1))
        .isLessThanOrEqualTo(largestStepWithin(size, (x, y) -> texture.argb(y, x)));
  }

  @ParameterizedTest
  @MethodSource("all")
  void theirSizesArePowersOfTwo(Texture texture) {
    assertThat(Integer.bitCount(texture.width())).isEqualTo(1);
    assertThat(texture.height()).isEqualTo(texture.width()).isLessThanOrEqualTo(1024);
  }

  @Test
  void theyAreMadeOnce() {
    assertThat(SurfaceTexture.BRICKS.texture()).isSameAs(SurfaceTexture.BRICKS.texture());
  }

  @ParameterizedTest
  @CsvSource({"0.1, 20", "0.35, 6", "0.4, 5", "1.5, 1", "2, 1"})
  void theFloorsTileHoldsWholeCellsOfTheGrid(double grid, int cells) {
    Texture floor = Parquet.TEXTURED.texture(grid);
    int middleOfFirstCell = floor.width() / cells / 2;

    assertThat(Parquet.cells(grid)).isEqualTo(cells);
    assertThat(brightness(floor, middleOfFirstCell)).isLessThan(brightness(floor) - 20);
  }

  @Test
  void calmBoardsHaveLessThanHalfOfTheContrast() {
    assertThat(contrast(ProceduralTexture.of(SurfaceTexture.SIZE, CalmTextures::oak)))
        .isBetween(2.0, contrast(SurfaceTexture.PARQUET.texture()) / 2);
  }

  /** Returns the standard deviation of luma. */
  private static double contrast(Texture texture) {
    double[] luma = Arrays.stream(texture.argbArray()).mapToDouble(TexturesTest::luma).toArray();
    double mean = Arrays.stream(luma).average().orElseThrow();
    double squares = Arrays.stream(luma).map(value -> value * value).average().orElseThrow();
    return Math.sqrt(squares - mean * mean);
  }

  private static double brightness(Texture texture) {
    return IntStream.range(0, texture.width())
        .mapToDouble(column -> brightness(texture, column))
        .average()
        .orElseThrow();
  }

  private static double brightness(Texture texture, int column) {
    return IntStream.range(0, texture.height())
        .mapToDouble(y -> luma(texture.argb(column, y)))
        .average()
        .orElseThrow();
  }

  /** Returns the mean change of brightness from a column to the next. */
  private static double step(int size, IntBinaryOperator argb, int column) {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      double here = luma(argb.applyAsInt(column, i));
      sum += Math.abs(luma(argb.applyAsInt((column + 1) % size, i)) - here);
    }
    return sum / size;
  }

  private static double largestStepWithin(int size, IntBinaryOperator argb) {
    return IntStream.range(0, size - 1)
        .mapToDouble(column -> step(size, argb, column))
        .max()
        .orElseThrow();
  }

  private static double luma(int argb) {
    return 0.299 * (argb >> 16 & 0xff) + 0.587 * (argb >> 8 & 0xff) + 0.114 * (argb & 0xff);
  }

  private static Stream<Arguments> all() {
    return Stream.of("bricks", "hexagons", "boards", "triangles", "panels", "parquet", "oak")
        .map(name -> Arguments.of(Named.of(name, texture(name))));
  }

  private static Texture texture(String name) {
    return switch (name) {
      case "bricks" -> SurfaceTexture.BRICKS.texture();
      case "hexagons" -> SurfaceTexture.HEXAGONS.texture();
      case "boards" -> SurfaceTexture.BOARDS.texture();
      case "triangles" -> SurfaceTexture.TRIANGLES.texture();
      case "panels" -> SurfaceTexture.PANELS.texture();
      case "parquet" -> Parquet.TEXTURED.texture(0.4);
      case "oak" -> Parquet.CALM.texture(0.4);
      default -> throw new IllegalArgumentException("there is no texture " + name);
    };
  }
}
