package tellosimulator.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.sim.SimSnapshot.Clock;
import tellosimulator.time.Pacer;
import tellosimulator.time.Threads;

/** Runs a simulation on a thread of its own, at the pace of its clock. */
public final class SimulationLoop implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(SimulationLoop.class);

  /** How often {@link #carryOut} looks whether the thread has been stopped [ms]. */
  private static final int PATIENCE_MS = 1000;

  private final Simulation simulation;
  private final Pacer pacer;
  private final Thread thread;
  private final Queue<CountDownLatch> waiting = new ConcurrentLinkedQueue<>();
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
    List<CountDownLatch> served = takeWaiting();
    try {
      simulation.drain();
    } finally {
      served.forEach(CountDownLatch::countDown);
    }
    adopt(simulation.clock());
    if (pacer.stepDue(simulation::busy)) {
      simulation.step();
    } else if (!simulation.pending()) {
      pacer.await();
    }
  }

  /** Those whose control lies in the inbox by now. */
  private List<CountDownLatch> takeWaiting() {
    List<CountDownLatch> served = new ArrayList<>();
    for (CountDownLatch latch = waiting.poll(); latch != null; latch = waiting.poll()) {
      served.add(latch);
    }
    return served;
  }

  private void adopt(Clock clock) {
    if (!pacer.factor().equals(clock.factor())) {
      pacer.setFactor(clock.factor());
    }
    if (pacer.paused() != clock.paused()) {
      pacer.setPaused(clock.paused());
    }
  }

  /**
   * Hands over what a person does, and waits until the snapshot shows it. For any thread but that
   * of the simulation.
   *
   * @throws IllegalArgumentException if there is no such drone
   */
  public void carryOut(Control control) {
    simulation.control(control);
    CountDownLatch taken = new CountDownLatch(1);
    waiting.add(taken);
    LockSupport.unpark(thread);
    try {
      while (!closed && !taken.await(PATIENCE_MS, TimeUnit.MILLISECONDS)) {
        LOG.debug("{} waits for the simulation", control);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Stops the thread and waits until it has ended. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
    Threads.join(thread);
  }
}
