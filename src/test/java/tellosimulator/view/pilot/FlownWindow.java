package tellosimulator.view.pilot;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import tellosimulator.model.FlightPhase;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.testing.ViewContexts;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.MediaFolder;
import tellosimulator.view.video.WindowVideo;

/** A running simulation with real sockets on free ports, and the context of a window for it. */
public final class FlownWindow implements AutoCloseable {

  /** The port for state and video, on which no program listens. */
  private static final int DISCARD = 9;

  /** Maximum wait by the wall clock [ns]. */
  private static final long PATIENCE_NANOS = 60_000_000_000L;

  private final List<SimEvent> events = new CopyOnWriteArrayList<>();
  private final OnlineSimulation simulation;
  private final ViewContext context;

  public FlownWindow(SimConfig config) {
    SimListener listener =
        new SimListener() {
          @Override
          public void event(SimEvent event) {
            events.add(event);
          }
        };
    simulation =
        new OnlineSimulation(
            config.withStreamPorts(new StreamPorts(DISCARD, DISCARD)),
            AddressPlan.portPerDrone(
                config.starts().size(), List.of(address("127.0.0.1", 0).getAddress()), 0),
            OptionalInt.empty(),
            List.of(listener));
    context =
        ViewContexts.of(
            simulation,
            new Language(Locale.ENGLISH),
            WindowVideo.of(simulation, DroneOptics.DEFAULT, MediaFolder.ofUser()));
  }

  public ViewContext context() {
    return context;
  }

  void carryOut(Control control) {
    try {
      simulation.carryOut(control);
    } catch (PortTakenException e) {
      throw new AssertionError(e);
    }
  }

  public void setCommandPort(int port) {
    simulation.setCommandPort(1, port);
  }

  /** Ticks until all actions of the window have been carried out. */
  void settle() {
    tickUntil(() -> !context.actions().pending());
  }

  void tick() {
    context.ticker().tick(System.nanoTime());
  }

  /** Ticks as a window does, until a condition is met. */
  void tickUntil(BooleanSupplier reached) {
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!reached.getAsBoolean()) {
      assertThat(System.nanoTime()).as("reached before the end of patience").isLessThan(end);
      tick();
      LockSupport.parkNanos(10_000_000);
    }
  }

  FlightPhase phase() {
    return simulation.snapshot().drones().get(0).state().phase();
  }

  int port() {
    return simulation.addresses(1).get(0).getPort();
  }

  /** The events so far, in order. */
  List<SimEvent> events() {
    return List.copyOf(events);
  }

  /** The commands that drone 1 has received so far, in order. */
  List<String> commands() {
    return events.stream()
        .filter(SimEvent.CommandReceived.class::isInstance)
        .map(SimEvent.CommandReceived.class::cast)
        .filter(command -> command.drone() == 1)
        .map(SimEvent.CommandReceived::text)
        .toList();
  }

  /** Whether drone 1 has replied to a command with this text. */
  boolean answered(String text) {
    return events.stream()
        .anyMatch(event -> event instanceof SimEvent.ReplySent reply && reply.text().equals(text));
  }

  @Override
  public void close() {
    context.actions().close();
    context.video().close();
    simulation.close();
  }
}
