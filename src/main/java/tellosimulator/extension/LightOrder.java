package tellosimulator.extension;

/** An order to the lights of the extension board. Immutable. */
public sealed interface LightOrder {

  /** Sets the effect of the lamp. */
  record Shine(LampEffect effect) implements LightOrder {}

  /** Sets the effect of the matrix. */
  record Show(MatrixEffect effect) implements LightOrder {}

  /**
   * Sets the brightness of the matrix.
   *
   * @param brightness 0 to 255
   */
  record Dim(int brightness) implements LightOrder {}

  /** Sets the picture of the matrix, both now and at each power-on. */
  record Greet(MatrixPicture picture) implements LightOrder {}
}
