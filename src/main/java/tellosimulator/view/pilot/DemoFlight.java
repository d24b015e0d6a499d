package tellosimulator.view.pilot;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyIntegerProperty;
import javafx.beans.property.ReadOnlyIntegerWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import tellosimulator.goal.Challenge;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;

/**
 * A flight that needs no operator program: a {@link GoalRoute} where there is one, or else a {@link
 * DemoTour}, command by command through the drone's real port. For the JavaFX thread; it moves on
 * with the pulse.
 */
public final class DemoFlight implements AutoCloseable {

  /** What it is about. */
  public enum Stage {
    IDLE,
    FLYING,
    /** It was stopped or failed in the air, and brings the drone down. */
    LANDING
  }

  /** What it flies for. */
  public enum Aim {
    /** The scenario asks for nothing. */
    TOUR,
    /** The goals of the scenario. */
    GOALS,
    /** The scenario has goals, but the drone cannot reach them on its own, or on no simple way. */
    TOUR_WITHOUT_GOALS
  }

  /** How long after the motors stopped the reply to {@code land} may come [ns]. Assumed. */
  private static final long LAST_REPLY_NANOS = 1_000_000_000;

  private final ViewContext context;
  private final ReadOnlyObjectWrapper<Stage> stage = new ReadOnlyObjectWrapper<>(Stage.IDLE);
  private final ReadOnlyBooleanWrapper running = new ReadOnlyBooleanWrapper();
  private final ReadOnlyStringWrapper command = new ReadOnlyStringWrapper("");
  private final ReadOnlyIntegerWrapper step = new ReadOnlyIntegerWrapper();
  private final ReadOnlyIntegerWrapper steps = new ReadOnlyIntegerWrapper();
  private final ReadOnlyObjectWrapper<Message> problem = new ReadOnlyObjectWrapper<>(Message.NONE);
  private final ReadOnlyObjectWrapper<Aim> aim = new ReadOnlyObjectWrapper<>(Aim.TOUR);
  private List<String> tour = List.of();
  private Optional<Flown> flown = Optional.empty();

  /** Counts starts and stops, so that a start that waits for power gives way to what is next. */
  private int starts;

  /** The drone that is flown, and by whom. */
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
    context.pulse().onBeat(this::beat);
  }

  /** Switches the selected drone on, if it is off, and flies. */
  void switchOnAndStart() {
    FxDroneModel drone = drone();
    if (drone.onProperty().get()) {
      start();
      return;
    }
    starts++;
    int mine = starts;
    context
        .actions()
        .switchPower(
            drone.number(),
            true,
            refusal ->
                refusal.ifPresentOrElse(
                    e -> problem.set(OperatorClient.portTaken(e)),
                    () -> {
                      if (mine == starts) {
                        fly(drone);
                      }
                    }));
  }

  /** Flies the selected drone, which must be on and stand on the floor. */
  void start() {
    FxDroneModel drone = drone();
    switch (drone.phaseProperty().get()) {
      case GROUNDED, IDLING -> fly(drone);
      case OFF -> problem.set(Message.of("off", Integer.toString(drone.number())));
      case CRASHED -> problem.set(Message.of("crashed"));
      case FALLING, TAKING_OFF, FLYING, LANDING -> problem.set(Message.of("not-on-the-floor"));
    }
  }

  /** Breaks the flight off and lands. */
  void stop() {
    starts++;
    if (stage.get() == Stage.FLYING) {
      comeDown();
    }
  }

  /** Ends at once; a drone in the air is left there. */
  @Override
  public void close() {
    starts++;
    end();
  }

  /** Something else is being done; what happened to the last tour is old news. */
  void forgetProblem() {
    problem.set(Message.NONE);
  }

  ReadOnlyObjectProperty<Stage> stageProperty() {
    return stage.getReadOnlyProperty();
  }

  /** Whether it flies or brings the drone down. */
  ReadOnlyBooleanProperty runningProperty() {
    return running.getReadOnlyProperty();
  }

  /** What was commanded last; empty when it does not run. */
  ReadOnlyStringProperty commandProperty() {
    return command.getReadOnlyProperty();
  }

  /** Which of the commands that is, from 1; 0 when it does not run. */
  ReadOnlyIntegerProperty stepProperty() {
    return step.getReadOnlyProperty();
  }

  /** How many commands the tour has. */
  ReadOnlyIntegerProperty stepsProperty() {
    return steps.getReadOnlyProperty();
  }

  /** What the flight is for, or the last one was. */
  ReadOnlyObjectProperty<Aim> aimProperty() {
    return aim.getReadOnlyProperty();
  }

  /** Why it did not come to its end; {@link Message#NONE} if there is nothing to say. */
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
    steps.set(tour.size());
    stage.set(Stage.FLYING);
    command(1);
  }

  private void plan(SimSnapshot snapshot, int drone) {
    Challenge challenge = context.scenario().challenge();
    Optional<List<String>> route = GoalRoute.commands(challenge, snapshot, drone);
    Aim otherwise = challenge.goals().isEmpty() ? Aim.TOUR : Aim.TOUR_WITHOUT_GOALS;
    aim.set(route.isPresent() ? Aim.GOALS : otherwise);
    tour = route.orElseGet(() -> new DemoTour(snapshot, drone).commands());
  }

  private void command(int number) {
    OperatorClient pilot = flown.orElseThrow().pilot;
    step.set(number);
    command.set(tour.get(number - 1));
    pilot.ask(command.get());
  }

  private void beat(long nanos) {
    if (stage.get() == Stage.FLYING) {
      advance(nanos);
    } else if (stage.get() == Stage.LANDING && flown.orElseThrow().descent.isDown(nanos)) {
      end();
    }
  }

  private void advance(long nanos) {
    Flown flight = flown.orElseThrow();
    Optional<OperatorClient.Answer> answer = flight.pilot.answer(nanos);
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
      if (!lands()) {
        problem.set(Message.of("flies-no-more", command.get()));
      }
      end();
    }
  }

  private void take(OperatorClient.Answer answer) {
    if (!answer.ok()) {
      problem.set(answer.problem());
      comeDown();
    } else if (step.get() == tour.size()) {
      end();
    } else {
      settle(command.get());
      command(step.get() + 1);
    }
  }

  /** The sticks' values survive landings; what an earlier operator left would carry it away. */
  private void settle(String done) {
    if (done.equals("command")) {
      flown.orElseThrow().pilot.tell("rc 0 0 0 0");
    }
  }

  private boolean lands() {
    return command.get().equals("land");
  }

  /** Whether its motors are off for so long that no reply is on its way. */
  private static boolean isDown(Flown flight, long nanos) {
    if (flight.downSince.isEmpty()) {
      flight.downSince = Optional.of(nanos);
    }
    return nanos - flight.downSince.get() >= LAST_REPLY_NANOS;
  }

  private void comeDown() {
    stage.set(Stage.LANDING);
    command.set("land");
  }

  private void end() {
    flown.ifPresent(flight -> flight.pilot.close());
    flown = Optional.empty();
    command.set("");
    step.set(0);
    stage.set(Stage.IDLE);
  }
}
