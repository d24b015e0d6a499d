package tellosimulator.extension;

import tellosimulator.time.SimTime;

/**
 * The state of the lights of an extension board, and the times at which their effects started.
 * Immutable.
 *
 * @param brightness the brightness of the matrix, 0 to 255
 * @param greeting the picture of the matrix at power-on
 */
public record BoardLights(
    LampEffect lamp,
    SimTime lampSince,
    MatrixEffect matrix,
    SimTime matrixSince,
    int brightness,
    MatrixPicture greeting) {

  /** Full brightness. Documented: SDK 3.0 User Guide. */
  public static final int BRIGHTEST = 255;

  /** Lights to which no order has been given. */
  public static final BoardLights DARK =
      new BoardLights(
          LampEffect.DARK,
          SimTime.ZERO,
          MatrixEffect.DARK,
          SimTime.ZERO,
          BRIGHTEST,
          MatrixPicture.DARK);

  /** Returns the lights after an order. */
  public BoardLights after(LightOrder order, SimTime now) {
    if (order instanceof LightOrder.Shine shine) {
      return new BoardLights(shine.effect(), now, matrix, matrixSince, brightness, greeting);
    }
    if (order instanceof LightOrder.Show show) {
      return new BoardLights(lamp, lampSince, show.effect(), now, brightness, greeting);
    }
    if (order instanceof LightOrder.Dim dim) {
      return new BoardLights(lamp, lampSince, matrix, matrixSince, dim.brightness(), greeting);
    }
    MatrixPicture picture = ((LightOrder.Greet) order).picture();
    return new BoardLights(lamp, lampSince, MatrixEffect.still(picture), now, brightness, picture);
  }

  /**
   * Returns the lights after power-on: the matrix shows the greeting, and everything else is in its
   * initial state.
   */
  public BoardLights poweredOn(SimTime now) {
    return new BoardLights(
        LampEffect.DARK, now, MatrixEffect.still(greeting), now, BRIGHTEST, greeting);
  }

  /** Returns the lights after power-off: dark, with the same greeting. */
  public BoardLights poweredOff() {
    return new BoardLights(
        LampEffect.DARK, SimTime.ZERO, MatrixEffect.DARK, SimTime.ZERO, BRIGHTEST, greeting);
  }

  /** Whether the lights are changing with time. */
  public boolean animated() {
    return lamp.animated() || matrix.animated();
  }

  /** Returns the colour of the lamp at a moment, as 0xrrggbb. Black means that the lamp is dark. */
  public int lampRgb(SimTime now) {
    return lamp.rgb(elapsed(lampSince, now));
  }

  /** Returns the picture of the matrix at a moment. */
  public MatrixPicture picture(SimTime now) {
    return matrix.picture(elapsed(matrixSince, now));
  }

  /** Returns the time since the start of an effect; 0 before the start. */
  private static double elapsed(SimTime since, SimTime now) {
    return Math.max(0, now.since(since));
  }
}
