package tellosimulator.board;

/** What a command asks of the lights of the extension board. Immutable. */
public sealed interface LightOrder {

  /** Lets the lamp show something. */
  record Shine(LampEffect effect) implements LightOrder {}

  /** Lets the matrix show something. */
  record Show(MatrixEffect effect) implements LightOrder {}

  /**
   * Dims the matrix.
   *
   * @param brightness 0 to 255
   */
  record Dim(int brightness) implements LightOrder {}

  /** Lets the matrix show a picture now, and whenever the power comes. */
  record Greet(MatrixPicture picture) implements LightOrder {}
}
