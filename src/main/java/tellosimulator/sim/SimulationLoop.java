package tellosimulator.sim;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.sim.SimSnapshot.Clock;
import tellosimulator.time.Pacer;

/** Runs a simulation on a thread of its own, at the pace that the simulation's clock sets. */
public final class SimulationLoop implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(SimulationLoop.class);

  /** Interval at which a waiting caller checks whether the thread has stopped [ms]. */
  private static final int PATIENCE_MS = 1000;

  private final Simulation simulation;
  private final Pacer pacer;
  private final Worker worker;

  /** Starts the thread. */
  public SimulationLoop(Simulation simulation) {
    this.simulation = simulation;
    this.pacer = new Pacer(simulation.clock().factor());
    this.worker = Worker.start("sim", new DutyCycle());
    simulation.onSubmit(worker::wake);
    worker.wake(); // for inputs submitted before the callback was set
  }

  /** Performs a step when one is due, and handles inputs when woken. */
  private final class DutyCycle implements Agent {

    private final ErrorPolicy failed = ErrorPolicy.retry("A step of the simulation failed");

    @Override
    public Outcome doWork() {
      return turn() ? Outcome.WORKED : Outcome.IDLE;
    }

    @Override
    public void idle() {
      pacer.await();
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return failed;
    }

    @Override
    public void onClose() {
      simulation.abandon();
    }
  }

  private boolean turn() {
    simulation.drain();
    adopt(simulation.clock());
    if (pacer.stepDue(simulation::demand)) {
      tellLost();
      simulation.step();
      return true;
    }
    return simulation.pending();
  }

  /**
   * Reports lost time. Ignores the time that was lost before the first command, while the program
   * was starting.
   */
  private void tellLost() {
    if (!simulation.commanded()) {
      pacer.forgiveLoss();
      return;
    }
    if (pacer.lostSeconds() != simulation.clock().lostSeconds()) {
      simulation.noteLost(pacer.lostSeconds());
    }
    pacer.lossToTell().ifPresent(simulation::tellLost);
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
   * Submits a control, and waits until the snapshot includes the change. Must not be called on the
   * simulation thread. Does not wait if the simulation is closed.
   *
   * @throws IllegalArgumentException if there is no such drone, or the configuration of a new run
   *     has another number of drones
   * @throws IllegalStateException if the simulation has ended because of an error
   */
  public void carryOut(Control control) {
    CountDownLatch shown = new CountDownLatch(1);
    simulation.control(control, shown::countDown);
    await(shown);
  }

  /**
   * Waits until the snapshot includes everything that programs have seen of the drones so far, and
   * until listeners have been notified of it. The wait is necessary because replies are sent before
   * listeners are notified. Must not be called on the simulation thread. Does not wait if the
   * simulation is closed.
   *
   * @throws IllegalStateException if the simulation has ended because of an error
   */
  public void settle() {
    CountDownLatch done = new CountDownLatch(1);
    simulation.afterAll(done::countDown);
    await(done);
  }

  private void await(CountDownLatch done) {
    try {
      while (!worker.hasEnded() && !done.await(PATIENCE_MS, TimeUnit.MILLISECONDS)) {
        LOG.debug("Somebody waits for the simulation");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (worker.failure().isPresent()) {
      throw new IllegalStateException("the simulation has ended because of an error");
    }
  }

  /**
   * Waits until all received commands have been carried out and answered, and nothing moves any
   * more. Must not be called on the simulation thread.
   *
   * @param limit the maximum time to wait
   * @return false on timeout
   */
  public boolean awaitStill(Duration limit) throws InterruptedException {
    CountDownLatch still = new CountDownLatch(1);
    simulation.onceStill(still::countDown);
    return still.await(limit.toMillis(), TimeUnit.MILLISECONDS);
  }

  /** Stops the thread and waits until it has ended. */
  @Override
  public void close() {
    worker.close();
  }
}
