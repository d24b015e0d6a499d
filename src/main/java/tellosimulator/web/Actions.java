package tellosimulator.web;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import tellosimulator.network.PortTakenException;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.TimeFactor;

/**
 * Carries out the actions of pages and of the teacher's board. They can open scenarios, and make
 * all requests of the control channel. Thread-safe.
 */
final class Actions {

  private final ScenarioHost host;

  Actions(ScenarioHost host) {
    this.host = host;
  }

  /**
   * Carries out an action.
   *
   * @param action the members of the action; {@code do} is its name
   * @return the result
   * @throws IllegalArgumentException if the action is invalid; the message is one sentence
   * @throws IllegalStateException if it cannot be carried out now; the message is one sentence
   */
  Object carryOut(Map<String, Object> action, WebTexts texts) {
    WebSubject subject = host.current();
    switch (text(action, "do")) {
      case "open" -> open(known(text(action, "scenario")), OptionalLong.empty(), texts);
      case "course" -> {
        OpenedScenario opened = subject.opened();
        if (!opened.varies()) {
          return subject.requests().result(Map.of("do", "reset")); // all its courses are the same
        }
        long next =
            action.containsKey("seed")
                ? (long) number(action, "seed")
                : opened.scenario().config().seed() + 1;
        open(opened, OptionalLong.of(next), texts);
      }
      case "pause" -> control(new Control.Pause(Boolean.TRUE.equals(action.get("on"))));
      case "time-factor" -> control(new Control.SetTimeFactor(factor(text(action, "factor"))));
      case "power-all" -> {
        for (DroneSnapshot drone : subject.simulation().snapshot().drones()) {
          long number = drone.state().drone(); // as in JSON
          subject
              .requests()
              .result(
                  Map.of(
                      "do", "power", "drone", number, "on", Boolean.TRUE.equals(action.get("on"))));
        }
      }
      default -> {
        return subject.requests().result(action);
      }
    }
    return Map.of();
  }

  private void control(Control control) {
    try {
      host.current().simulation().carryOut(control);
    } catch (PortTakenException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  private static TimeFactor factor(String word) {
    if (word.equals(TimeFactor.MAX.toString())) {
      return TimeFactor.MAX;
    }
    if (!word.matches("[0-9]{1,6}(\\.[0-9]{1,6})?")) {
      throw new IllegalArgumentException("factor must be a number or max");
    }
    return new TimeFactor(Double.parseDouble(word));
  }

  private static OpenedScenario known(String name) {
    return name.isEmpty()
        ? OpenedScenario.once(Scenario.of(SimConfig.DEFAULT))
        : Gallery.open(name)
            .map(document -> OpenedScenario.known(document, name))
            .orElseThrow(() -> new IllegalArgumentException("there is no such scenario"));
  }

  /**
   * Opens a scenario that a browser has sent; see {@link #carryOut}.
   *
   * @param name the name of its file
   */
  void open(String name, byte[] bytes, WebTexts texts) {
    try {
      open(OpenedScenario.received(name, bytes), OptionalLong.empty(), texts);
    } catch (ScenarioException e) {
      throw complaint(e, texts);
    }
  }

  private void open(OpenedScenario chosen, OptionalLong seed, WebTexts texts) {
    try {
      host.open(chosen, seed);
    } catch (ScenarioException e) {
      throw complaint(e, texts);
    } catch (PortTakenException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  private static IllegalArgumentException complaint(ScenarioException e, WebTexts texts) {
    return new IllegalArgumentException(e.diagnostics().get(0).in(texts.translation()), e);
  }

  static String text(Map<String, Object> action, String name) {
    return String.valueOf(action.getOrDefault(name, ""));
  }

  /**
   * Returns a number.
   *
   * @throws IllegalArgumentException if there is none; the message is one sentence
   */
  static double number(Map<String, Object> action, String name) {
    return Optional.ofNullable(action.get(name))
        .filter(Number.class::isInstance)
        .map(value -> ((Number) value).doubleValue())
        .filter(Double::isFinite)
        .orElseThrow(() -> new IllegalArgumentException(name + " must be a number"));
  }
}
