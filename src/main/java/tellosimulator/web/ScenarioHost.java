package tellosimulator.web;

import java.util.Optional;
import java.util.OptionalLong;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.ScenarioException;

/** A simulator in which browsers open one scenario after another. Thread-safe. */
public interface ScenarioHost {

  /** Returns the scenario that is being flown. */
  WebSubject current();

  /** Returns the folder in which flights are recorded; empty if they are not. */
  Optional<RecordingFolder> recordings();

  /**
   * Ends the current scenario and begins another one, with all drones on.
   *
   * @param seed the seed of its course; if empty, that of the options or of the scenario
   * @throws ScenarioException if no course of this seed fits
   * @throws IllegalArgumentException if the command-line options do not fit the scenario; the
   *     message is one sentence. The current scenario goes on
   * @throws PortTakenException if a drone's address or port cannot be opened
   */
  void open(OpenedScenario chosen, OptionalLong seed) throws ScenarioException, PortTakenException;
}
