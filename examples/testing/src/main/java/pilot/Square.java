package pilot;

import java.io.IOException;

/** Flies a square, and lands where it began. */
public final class Square {

  private static final int LEAST_BATTERY = 20;

  private final Tello tello;

  public Square(Tello tello) {
    this.tello = tello;
  }

  /** Flies, unless the battery is too low; lands also when something goes wrong on the way. */
  public void fly(int edge) throws IOException {
    tello.command("command");
    if (Integer.parseInt(tello.send("battery?")) < LEAST_BATTERY) {
      return;
    }
    tello.command("takeoff");
    try {
      for (int corner = 0; corner < 4; corner++) {
        tello.command("forward " + edge);
        tello.command("cw 90");
      }
    } finally {
      tello.command("land");
    }
  }
}
