package tellosimulator.recording;

import java.util.OptionalInt;
import tellosimulator.goal.Challenge;
import tellosimulator.sim.SimConfig;

/**
 * The initial conditions of a simulation; together with its inputs they determine all that follows.
 * Immutable; for any thread.
 *
 * @param config what is simulated
 * @param challenge what the drones shall do
 * @param replyPort port to which all replies go; empty for the port each command came from
 */
public record InitialConditions(SimConfig config, Challenge challenge, OptionalInt replyPort) {

  /** The same for drones that shall do something else. */
  InitialConditions withChallenge(Challenge newChallenge) {
    return new InitialConditions(config, newChallenge, replyPort);
  }
}
