package tellosimulator.goal;

import java.util.List;
import java.util.Map;
import java.util.OptionalInt;

/**
 * What happened in an attempt, as numbers, whether or not the challenge has points. Immutable.
 *
 * @param commands the number of commands that the drones took, with reads
 * @param infractions the number of each infraction; an infraction that is missing did not happen
 * @param winners for each goal, the number of the drone that reached it; empty if none did
 */
public record Tally(int commands, Map<Infraction, Integer> infractions, List<OptionalInt> winners) {

  public Tally {
    infractions = Map.copyOf(infractions);
    winners = List.copyOf(winners);
  }

  /** Returns how often an infraction happened. */
  public int count(Infraction infraction) {
    return infractions.getOrDefault(infraction, 0);
  }
}
