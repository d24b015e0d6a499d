package tellosimulator.scenery.room;

import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.ProceduralTexture;

/**
 * A wooden floor with the lines of the grid on it. Its tile holds whole cells of the grid, so it is
 * only about as wide as a {@link SurfaceTexture#TILE}; what is on it becomes wider or narrower.
 */
final class Parquet {

  private static final int LINE = Rgb.of(0x33302c).argb();

  /** Decided: by eye. */
  private static final double LINE_OPACITY = 0.6;

  private Parquet() {}

  /** How many cells of a grid are in a tile, across and down. */
  static int cells(double grid) {
    return (int) Math.max(1, Math.round(SurfaceTexture.TILE / grid));
  }

  /**
   * A tile. Lines cross in the middle of its first cell.
   *
   * @param grid distance from line to line [m]
   */
  static Texture texture(double grid) {
    int size = SurfaceTexture.SIZE;
    return Texture.lazy(size, size, () -> argb(lineOpacity(grid)));
  }

  private static int[] argb(double[] line) {
    int[] argb = SurfaceTexture.PARQUET.texture().argbArray();
    for (int i = 0; i < argb.length; i++) {
      int row = i / line.length;
      double opacity = Math.max(line[row], line[i - row * line.length]);
      if (opacity > 0) {
        argb[i] = ProceduralTexture.mix(argb[i], LINE, opacity);
      }
    }
    return argb;
  }

  /** How opaque the lines are at each texel across, which is the same down. */
  private static double[] lineOpacity(double grid) {
    double cell = (double) SurfaceTexture.SIZE / cells(grid);
    double halfLine = Math.max(1.5, (0.0035 / grid + 0.0075) * cell);
    double[] opacity = new double[SurfaceTexture.SIZE];
    for (int i = 0; i < opacity.length; i++) {
      double cells = (i + 0.5) / cell;
      double fromLine = Math.abs(cells - (int) cells - 0.5) * cell;
      opacity[i] = LINE_OPACITY * Math.max(0, Math.min(1, halfLine - fromLine + 0.5));
    }
    return opacity;
  }
}
