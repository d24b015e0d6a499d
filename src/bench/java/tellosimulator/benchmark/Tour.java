package tellosimulator.benchmark;

import java.io.IOException;
import java.util.List;

/** A flight of about half a minute that ends where it began. */
public final class Tour {

  private static final List<String> MOVES = List.of("forward 50", "cw 180", "forward 50", "cw 180");

  private Tour() {}

  /** From takeoff to landing, with a query after each move. */
  public static void fly(Operator operator) throws IOException {
    operator.expect("takeoff", "ok");
    for (String move : MOVES) {
      operator.expect(move, "ok");
      operator.ask("battery?");
    }
    operator.expect("land", "ok");
  }
}
