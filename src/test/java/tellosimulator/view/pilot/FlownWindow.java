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
import tellosimulator.view.text.Language;
import tellosimulator.view.video.MediaFolder;
import tellosimulator.view.video.WindowVideo;

/** A running simulation with real sockets on free ports, and the context of a window on it. */
public final class FlownWindow implements AutoCloseable {

  /** State and video go where nobody listens. */
  private static final int DISCARD = 9;

  /** Longest wait by the wall clock [ns]. */
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
        ViewContext.of(
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

  /** Beats until all that was done in the window has been carried out. */
  void settle() {
    beatUntil(() -> !context.actions().pending());
  }

  void beat() {
    context.pulse().beat(System.nanoTime());
  }

  /** Beats as a window does, until something is so. */
  void beatUntil(BooleanSupplier reached) {
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!reached.getAsBoolean()) {
      assertThat(System.nanoTime()).as("reached before the end of patience").isLessThan(end);
      beat();
      LockSupport.parkNanos(10_000_000);
    }
  }

  FlightPhase phase() {
    return simulation.snapshot().drones().get(0).state().phase();
  }

  int port() {
    return simulation.addresses(1).get(0).getPort();
  }

  /** What happened so far, in order. */
  List<SimEvent> events() {
    return List.copyOf(events);
  }

  /** The commands that drone 1 received so far, in order. */
  List<String> commands() {
    return events.stream()
        .filter(SimEvent.CommandReceived.class::isInstance)
        .map(SimEvent.CommandReceived.class::cast)
        .filter(command -> command.drone() == 1)
        .map(SimEvent.CommandReceived::text)
        .toList();
  }

  @Override
  public void close() {
    context.actions().close();
    context.video().close();
    simulation.close();
  }
}
