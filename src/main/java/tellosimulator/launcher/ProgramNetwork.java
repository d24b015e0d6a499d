package tellosimulator.launcher;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The network in which a program finds the drones. Not thread-safe. */
interface ProgramNetwork extends AutoCloseable {

  /** Wraps the command of a simulator, including its listen addresses. */
  List<String> simulator(List<String> command);

  /** Wraps the command of the operator program. */
  List<String> program(List<String> command, Optional<Confinement> confinement);

  /**
   * Whether the started process of the program only waits for the first process of a PID namespace.
   */
  boolean ownsProcesses();

  /**
   * Returns the environment variables with which the program finds the drones.
   *
   * @param ready the line in which the simulator has reported where its drones listen
   * @throws IOException if that line does not name each drone; the message is a clause
   */
  Map<String, String> variables(String ready) throws IOException;

  @Override
  void close();
}
