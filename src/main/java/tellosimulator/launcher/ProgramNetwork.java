package tellosimulator.launcher;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The network in which a program finds the drones. Not thread-safe. */
interface ProgramNetwork extends AutoCloseable {

  /** Wraps the command of a simulator, including its listen addresses. */
  List<String> simulator(List<String> command);

  /** Wraps the command of the operator program. */
  List<String> program(List<String> command, Optional<Confinement> confinement);

  /** Returns the variables that tell a program where the drones are; empty if it knows. */
  Map<String, String> variables();

  @Override
  void close();
}
