package tellosimulator.board;

import tellosimulator.time.SimTime;

/**
 * What the lights of an extension board were told to do, and since when. Immutable; for any thread.
 *
 * @param brightness of the matrix, 0 to 255
 * @param greeting what the matrix shows when the power comes
 */
public record BoardLights(
    LampEffect lamp,
    SimTime lampSince,
    MatrixEffect matrix,
    SimTime matrixSince,
    int brightness,
    MatrixPicture greeting) {

  /** Full light. Documented: SDK 3.0 User Guide. */
  public static final int BRIGHTEST = 255;

  /** Nobody has told it anything. */
  public static final BoardLights DARK =
      new BoardLights(
          LampEffect.DARK,
          SimTime.ZERO,
          MatrixEffect.DARK,
          SimTime.ZERO,
          BRIGHTEST,
          MatrixPicture.DARK);

  /** What becomes of it by an order. */
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

  /** The power comes: all is as new, but for the greeting. */
  public BoardLights poweredOn(SimTime now) {
    return new BoardLights(
        LampEffect.DARK, now, MatrixEffect.still(greeting), now, BRIGHTEST, greeting);
  }

  /** The power goes. */
  public BoardLights poweredOff() {
    return new BoardLights(
        LampEffect.DARK, SimTime.ZERO, MatrixEffect.DARK, SimTime.ZERO, BRIGHTEST, greeting);
  }

  /** Whether something of it changes by itself. */
  public boolean animated() {
    return lamp.animated() || matrix.animated();
  }

  /** The colour of the lamp at a moment, as one writes #rrggbb; black is dark. */
  public int lampRgb(SimTime now) {
    return lamp.rgb(elapsed(lampSince, now));
  }

  /** What the matrix shows at a moment. */
  public MatrixPicture picture(SimTime now) {
    return matrix.picture(elapsed(matrixSince, now));
  }

  /** 0 for moments before. */
  private static double elapsed(SimTime since, SimTime now) {
    return Math.max(0, now.since(since));
  }
}
