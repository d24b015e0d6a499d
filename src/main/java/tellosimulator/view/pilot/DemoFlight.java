package tellosimulator.view.pilot;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import tellosimulator.goal.Challenge;
import tellosimulator.model.FlightPhase;
import tellosimulator.pilot.DemoTour;
import tellosimulator.pilot.GoalRoute;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;

/**
 * A flight without an operator program. It follows a {@link GoalRoute} if there is one, and
 * otherwise a {@link DemoTour}, and sends the commands one by one to the drone's UDP command port.
 * Confined to the JavaFX thread; advances with the UI ticks.
 */
public final class DemoFlight implements AutoCloseable {

  /** The state of the demo flight. */
  public enum Stage {
    IDLE,
    FLYING,
    /** The flight was stopped or failed in the air, and the drone is being landed. */
    LANDING
  }

  /** The purpose of the flight. */
  public enum Aim {
    /** A tour, because the scenario has no goals. */
    TOUR,
    /** The goals of the scenario. */
    GOALS,
    /** A tour, because the drone cannot reach the scenario's goals alone or on a simple route. */
    TOUR_WITHOUT_GOALS
  }

  /**
   * A step of the flight.
   *
   * @param number the number of the command, from 1; 0 while no flight is running
   * @param count the number of commands in the flight
   * @param command the command of this step; empty while no flight is running
   */
  record Step(Aim aim, int number, int count, String command) {

    private static final Step NONE = new Step(Aim.TOUR, 0, 0, "");
  }

  /** Maximum time from the stop of the motors to the reply to {@code land} [ns]. Assumed. */
  private static final long LAST_REPLY_NANOS = 1_000_000_000;

  private final ViewContext context;
  private final ReadOnlyObjectWrapper<Stage> stage = new ReadOnlyObjectWrapper<>(Stage.IDLE);
  private final ReadOnlyBooleanWrapper running = new ReadOnlyBooleanWrapper();
  private final ReadOnlyObjectWrapper<Step> step = new ReadOnlyObjectWrapper<>(Step.NONE);
  private final ReadOnlyObjectWrapper<Message> problem = new ReadOnlyObjectWrapper<>(Message.NONE);
  private Aim aim = Aim.TOUR;
  private List<String> tour = List.of();
  private Optional<Flown> flown = Optional.empty();

  /**
   * Number of starts and stops so far. A start that is waiting for the drone to be switched on is
   * superseded by any later start or stop.
   */
  private int starts;

  /** The drone that is being flown, with its operator. */
  private static final class Flown {
    private final FxDroneModel drone;
    private final OperatorClient pilot;
    private final Descent descent;
    private boolean tookOff;
    private Optional<Long> downSince = Optional.empty();

    Flown(FxDroneModel drone, OperatorClient pilot) {
      this.drone = drone;
      this.pilot = pilot;
      this.descent = new Descent(drone, pilot);
    }

    FlightPhase phase() {
      return drone.phaseProperty().get();
    }
  }

  public DemoFlight(ViewContext context) {
    this.context = context;
    running.bind(stage.isNotEqualTo(Stage.IDLE));
    context.ticker().onTick(this::tick);
  }

  /** Switches the selected drone on if necessary, and flies it. */
  void switchOnAndStart() {
    FxDroneModel drone = drone();
    if (drone.onProperty().get()) {
      start();
      return;
    }
    starts++;
    int mine = starts;
    OperatorClient.switchOn(
        context,
        drone,
        problem::set,
        () -> {
          if (mine == starts) {
            fly(drone);
          }
        });
  }

  /**
   * Flies the selected drone if it is on and stands on the floor; otherwise sets {@link
   * #problemProperty}.
   */
  void start() {
    FxDroneModel drone = drone();
    switch (drone.phaseProperty().get()) {
      case GROUNDED, IDLING -> fly(drone);
      case OFF -> problem.set(Message.of("off", Integer.toString(drone.number())));
      case CRASHED -> problem.set(Message.of("crashed"));
      case FALLING, TAKING_OFF, FLYING, LANDING -> problem.set(Message.of("not-on-the-floor"));
    }
  }

  /** Aborts the flight and lands the drone. */
  void stop() {
    starts++;
    if (stage.get() == Stage.FLYING) {
      comeDown();
    }
  }

  /** Ends the flight at once, without landing the drone. */
  @Override
  public void close() {
    starts++;
    end();
  }

  /** Clears the problem of the last flight, because another action starts. */
  void forgetProblem() {
    problem.set(Message.NONE);
  }

  ReadOnlyObjectProperty<Stage> stageProperty() {
    return stage.getReadOnlyProperty();
  }

  /** Whether the demo is flying or landing the drone. */
  ReadOnlyBooleanProperty runningProperty() {
    return running.getReadOnlyProperty();
  }

  /** The current step. */
  ReadOnlyObjectProperty<Step> stepProperty() {
    return step.getReadOnlyProperty();
  }

  /** The reason why the last flight was not completed; {@link Message#NONE} if there is none. */
  ReadOnlyObjectProperty<Message> problemProperty() {
    return problem.getReadOnlyProperty();
  }

  private FxDroneModel drone() {
    return context.simulation().selected();
  }

  private void fly(FxDroneModel drone) {
    end();
    problem.set(Message.NONE);
    try {
      flown = Optional.of(new Flown(drone, new OperatorClient(context, drone)));
    } catch (IOException e) {
      problem.set(Message.of("no-socket", e.getMessage()));
      return;
    }
    plan(context.simulation().snapshot(), drone.number());
    stage.set(Stage.FLYING);
    command(1);
  }

  private void plan(SimSnapshot snapshot, int drone) {
    Challenge challenge = context.scenario().challenge();
    Optional<List<String>> route = GoalRoute.commands(challenge, snapshot, drone);
    Aim otherwise = challenge.goals().isEmpty() ? Aim.TOUR : Aim.TOUR_WITHOUT_GOALS;
    aim = route.isPresent() ? Aim.GOALS : otherwise;
    tour = route.orElseGet(() -> new DemoTour(snapshot, drone).commands());
  }

  private void command(int number) {
    show(number, tour.get(number - 1));
    flown.orElseThrow().pilot.ask(command());
  }

  private void show(int number, String command) {
    step.set(new Step(aim, number, tour.size(), command));
  }

  private String command() {
    return step.get().command();
  }

  private void tick(long nanos) {
    if (stage.get() == Stage.FLYING) {
      advance(nanos);
    } else if (stage.get() == Stage.LANDING && flown.orElseThrow().descent.isDown(nanos)) {
      end();
    }
  }

  private void advance(long nanos) {
    Flown flight = flown.orElseThrow();
    Optional<Message> answer = flight.pilot.answer(nanos);
    if (answer.isPresent()) {
      take(answer.get());
      return;
    }
    boolean flies = flight.phase().flying();
    flight.tookOff |= flies;
    if (flies) {
      flight.downSince = Optional.empty();
    }
    if (flight.tookOff && !flies && isDown(flight, nanos)) {
      if (!command().equals("land")) {
        problem.set(Message.of("flies-no-more", command()));
      }
      end();
    }
  }

  private void take(Message failure) {
    if (!failure.isNone()) {
      problem.set(failure);
      comeDown();
    } else if (step.get().number() == tour.size()) {
      end();
    } else {
      settle(command());
      command(step.get().number() + 1);
    }
  }

  /**
   * Centres the sticks after {@code command}. Stick values persist across landings, so the values
   * of an earlier operator would otherwise move the drone.
   */
  private void settle(String done) {
    if (done.equals("command")) {
      flown.orElseThrow().pilot.tell("rc 0 0 0 0");
    }
  }

  /** Returns whether the motors have been off for so long that no reply can be pending. */
  private static boolean isDown(Flown flight, long nanos) {
    if (flight.downSince.isEmpty()) {
      flight.downSince = Optional.of(nanos);
    }
    return nanos - flight.downSince.get() >= LAST_REPLY_NANOS;
  }

  private void comeDown() {
    stage.set(Stage.LANDING);
    show(step.get().number(), "land");
  }

  private void end() {
    flown.ifPresent(flight -> flight.pilot.close());
    flown = Optional.empty();
    step.set(Step.NONE);
    stage.set(Stage.IDLE);
  }
}
