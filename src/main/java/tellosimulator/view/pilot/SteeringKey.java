package tellosimulator.view.pilot;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import javafx.scene.input.KeyCode;

/** The keys that fly a drone, and how they move the sticks of {@code rc}. */
public enum SteeringKey {
  FORWARD(KeyCode.W, "W", new Push(0, 1, 0, 0)),
  BACK(KeyCode.S, "S", new Push(0, -1, 0, 0)),
  LEFT(KeyCode.A, "A", new Push(-1, 0, 0, 0)),
  RIGHT(KeyCode.D, "D", new Push(1, 0, 0, 0)),
  UP(KeyCode.UP, "↑", new Push(0, 0, 1, 0)),
  DOWN(KeyCode.DOWN, "↓", new Push(0, 0, -1, 0)),
  TURN_LEFT(KeyCode.LEFT, "←", new Push(0, 0, 0, -1)),
  TURN_RIGHT(KeyCode.RIGHT, "→", new Push(0, 0, 0, 1)),
  FASTER(KeyCode.SHIFT, "⇧", Push.NONE),
  TAKE_OFF_OR_LAND(KeyCode.SPACE, "␣", Push.NONE),
  FLIP(KeyCode.F, "F", Push.NONE),
  EMERGENCY(KeyCode.X, "X", Push.NONE);

  /**
   * The directions in which a key pushes the sticks, in the order of {@code rc}: right, forward,
   * up, clockwise. Each is -1, 0 or 1.
   */
  record Push(int right, int forward, int up, int clockwise) {

    static final Push NONE = new Push(0, 0, 0, 0);

    Push plus(Push other) {
      return new Push(
          right + other.right, forward + other.forward, up + other.up, clockwise + other.clockwise);
    }
  }

  private final KeyCode code;
  private final String symbol;
  private final Push push;

  SteeringKey(KeyCode code, String symbol, Push push) {
    this.code = code;
    this.symbol = symbol;
    this.push = push;
  }

  /** Returns the symbol printed on the key. */
  public String symbol() {
    return symbol;
  }

  Push push() {
    return push;
  }

  /** Returns the message key of the description, in this package's messages. */
  public String textKey() {
    return "key-" + name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  static Optional<SteeringKey> of(KeyCode code) {
    return Arrays.stream(values()).filter(key -> key.code == code).findFirst();
  }
}
