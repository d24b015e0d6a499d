package tellosimulator.launcher;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The network of this machine, for systems without private networks. The program must read from
 * {@code TELLO_HOST} and {@code TELLO_PORT} where its drone is. Immutable.
 */
final class SharedNetwork implements ProgramNetwork {

  private static final String HOST = "127.0.0.1";

  /** Decided: the default port of the simulator, because 8889 is often taken by the program. */
  private static final String PORT = "8879";

  @Override
  public List<String> simulator(List<String> command) {
    return ProgramRun.joined(command, List.of("--bind", HOST, "--command-port", PORT));
  }

  @Override
  public List<String> program(List<String> command, Optional<Confinement> confinement) {
    return command;
  }

  @Override
  public Map<String, String> variables() {
    return Map.of("TELLO_HOST", HOST, "TELLO_PORT", PORT);
  }

  @Override
  public void close() {
    // there is nothing to release
  }
}
