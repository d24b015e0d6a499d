package tellosimulator.scenery.room;

import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.ProceduralTexture;
import tellosimulator.scenery.texture.ProceduralTexture.Texels;

/**
 * Wooden floors with grid lines. A tile must hold a whole number of grid cells, so its side length
 * only approximates {@link SurfaceTexture#TILE}, and the wood on it is stretched accordingly.
 */
enum Parquet {
  /** High-contrast wood with lines that are clearly visible to a camera. */
  TEXTURED(Rgb.of(0x33302c), 0.6, 1) {
    @Override
    Texels wood() {
      return SurfaceTexture.PARQUET.texture()::argb;
    }
  },

  /** Light wood with lines that are fainter than a drone's shadow. */
  CALM(Rgb.of(0x6e5f4c), 0.36, 0.45) {
    @Override
    Texels wood() {
      return CalmTextures.oak();
    }
  };

  /** Half the width of the thinnest line, before it is multiplied by {@link #width} [texels]. */
  private static final double THINNEST = 1.5;

  private final int line;
  private final double opacity;
  private final double width;

  /**
   * Creates a floor. Decided: all three values, by eye.
   *
   * @param line colour of the lines
   * @param opacity opacity of the lines, 0 to 1
   * @param width width of the lines, relative to the lines of {@link #TEXTURED}
   */
  Parquet(Rgb line, double opacity, double width) {
    this.line = line.argb();
    this.opacity = opacity;
    this.width = width;
  }

  /** Computes a tile without lines. */
  abstract Texels wood();

  /** Returns the number of grid cells in a tile, across and down. */
  static int cells(double grid) {
    return (int) Math.max(1, Math.round(SurfaceTexture.TILE / grid));
  }

  /**
   * Returns a tile with lines that cross in the middle of each grid cell.
   *
   * @param grid distance between lines [m]
   */
  Texture texture(double grid) {
    return ProceduralTexture.of(SurfaceTexture.SIZE, () -> lined(wood(), lineOpacity(grid)));
  }

  private Texels lined(Texels wood, double[] lines) {
    return (x, y) -> {
      double covered = Math.max(lines[y], lines[x]);
      int argb = wood.argb(x, y);
      return covered > 0 ? ProceduralTexture.mix(argb, line, covered) : argb;
    };
  }

  /**
   * Returns the opacity of the lines for each column of texels. The values for the rows are the
   * same.
   */
  private double[] lineOpacity(double grid) {
    double cell = (double) SurfaceTexture.SIZE / cells(grid);
    double halfLine = width * Math.max(THINNEST, (0.0035 / grid + 0.0075) * cell);
    double[] lines = new double[SurfaceTexture.SIZE];
    for (int i = 0; i < lines.length; i++) {
      double cells = (i + 0.5) / cell;
      double fromLine = Math.abs(cells - (int) cells - 0.5) * cell;
      lines[i] = opacity * Math.max(0, Math.min(1, halfLine - fromLine + 0.5));
    }
    return lines;
  }
}
