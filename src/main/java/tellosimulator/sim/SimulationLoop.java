package tellosimulator.sim;

import java.util.concurrent.locks.LockSupport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.sim.SimSnapshot.Clock;
import tellosimulator.time.Pacer;
import tellosimulator.time.Threads;

/** Runs a simulation on a thread of its own, at the pace of its clock. */
public final class SimulationLoop implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(SimulationLoop.class);

  private final Simulation simulation;
  private final Pacer pacer;
  private final Thread thread;
  private volatile boolean closed;

  /** Starts at once. */
  public SimulationLoop(Simulation simulation) {
    this.simulation = simulation;
    this.pacer = new Pacer(simulation.clock().factor());
    this.thread = Threads.start("sim", this::run);
    simulation.onSubmit(() -> LockSupport.unpark(thread));
  }

  private void run() {
    while (!closed) {
      try {
        turn();
      } catch (RuntimeException e) {
        LOG.error("A step failed; please report this: {}", e.toString(), e);
        Threads.backOff();
      }
    }
  }

  private void turn() {
    simulation.drain();
    adopt(simulation.clock());
    if (pacer.stepDue(simulation::busy)) {
      simulation.step();
    } else if (!simulation.pending()) {
      pacer.await();
    }
  }

  private void adopt(Clock clock) {
    if (!pacer.factor().equals(clock.factor())) {
      pacer.setFactor(clock.factor());
    }
    if (pacer.paused() != clock.paused()) {
      pacer.setPaused(clock.paused());
    }
  }

  /** Stops the thread and waits until it has ended. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
