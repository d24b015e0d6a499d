package tellosimulator.scenery.room;

import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.ProceduralTexture;

/**
 * Wooden floors with the lines of the grid on them. Their tile holds whole cells of the grid, so it
 * is only about as wide as a {@link SurfaceTexture#TILE}; what is on it becomes wider or narrower.
 */
enum Parquet {
  /** Wood with much contrast, which a camera sees. */
  TEXTURED(Rgb.of(0x33302c), 0.6, 1) {
    @Override
    Texture wood() {
      return SurfaceTexture.PARQUET.texture();
    }
  },

  /** Light wood, whose lines are fainter than a drone's shadow. */
  CALM(Rgb.of(0x6e5f4c), 0.36, 0.45) {
    @Override
    Texture wood() {
      return CalmTextures.boards();
    }
  };

  /** Half the width of the thinnest line, before its {@link #width} [texels]. */
  private static final double THINNEST = 1.5;

  private final int line;
  private final double opacity;
  private final double width;

  /**
   * @param line colour of the lines. Decided: by eye, as the rest
   * @param opacity of the lines, 0 to 1
   * @param width of the lines, compared with those of textured floors
   */
  Parquet(Rgb line, double opacity, double width) {
    this.line = line.argb();
    this.opacity = opacity;
    this.width = width;
  }

  /** A tile without lines. */
  abstract Texture wood();

  /** How many cells of a grid are in a tile, across and down. */
  static int cells(double grid) {
    return (int) Math.max(1, Math.round(SurfaceTexture.TILE / grid));
  }

  /**
   * A tile. Lines cross in the middle of its first cell.
   *
   * @param grid distance from line to line [m]
   */
  Texture texture(double grid) {
    int size = SurfaceTexture.SIZE;
    return Texture.lazy(size, size, () -> argb(lineOpacity(grid)));
  }

  private int[] argb(double[] lines) {
    int[] argb = wood().argbArray();
    for (int i = 0; i < argb.length; i++) {
      int row = i / lines.length;
      double covered = Math.max(lines[row], lines[i - row * lines.length]);
      if (covered > 0) {
        argb[i] = ProceduralTexture.mix(argb[i], line, covered);
      }
    }
    return argb;
  }

  /** How opaque the lines are at each texel across, which is the same down. */
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
