package pilot;

import java.io.IOException;

/** Flies a square, and lands where it began. */
public final class Square {

  private static final int LEAST_BATTERY = 20;

  private final Tello tello;

  public Square(Tello tello) {
    this.tello = tello;
  }

  /** Flies, unless the battery is too low. */
  public void fly(int edge) throws IOException {
    tello.ask("command");
    if (Integer.parseInt(tello.ask("battery?")) < LEAST_BATTERY) {
      return;
    }
    tello.send("takeoff");
    for (int corner = 0; corner < 4; corner++) {
      tello.send("forward " + edge);
      tello.send("cw 90");
    }
    tello.send("land");
  }
}
