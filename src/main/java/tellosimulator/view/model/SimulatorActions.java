package tellosimulator.view.model;

import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.ObjIntConsumer;
import javafx.application.Platform;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.network.Reach;
import tellosimulator.network.Silence;
import tellosimulator.network.Traffic;
import tellosimulator.sim.Control;

/**
 * Carries out the user's actions on the simulation. Confined to the JavaFX thread, which is never
 * blocked: a worker carries out the actions in order, because opening a port or waiting for a busy
 * simulation may take a while. Each answer is delivered at the UI tick whose snapshot shows the
 * result of the action.
 */
public final class SimulatorActions implements AutoCloseable {

  /** An action that may take a while. */
  @FunctionalInterface
  private interface Task {
    void run() throws PortTakenException;
  }

  private final OnlineSimulation simulation;
  private final BlockingQueue<Runnable> tasks = new LinkedBlockingQueue<>();
  private final Queue<Runnable> answers = new ConcurrentLinkedQueue<>();

  /** The answers that arrived before the displayed snapshot was taken. */
  private final Queue<Runnable> due = new ArrayDeque<>();

  private volatile Runnable answered = () -> {};
  private final Worker worker;
  private ObjIntConsumer<PortTakenException> refused = (refusal, drone) -> {};
  private final AtomicInteger pending = new AtomicInteger();

  SimulatorActions(OnlineSimulation simulation) {
    this.simulation = simulation;
    worker = Worker.start("window-actions", new Tasks());
  }

  /**
   * Sets a listener that is notified whenever an answer is ready for {@link #collect}.
   *
   * @param listener called on the worker's thread
   */
  void onAnswered(Runnable listener) {
    answered = listener;
  }

  /** Carries out one task after another. A failure is logged and does not affect the next task. */
  private final class Tasks implements Agent {

    private final ErrorPolicy failed = ErrorPolicy.goOn("What was done in the window failed");

    @Override
    public Outcome doWork() throws InterruptedException {
      tasks.take().run();
      return Outcome.WORKED;
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return failed;
    }
  }

  /** Switches a drone on or off. */
  public void switchPower(int drone, boolean on) {
    switchPower(drone, on, refusal -> {});
  }

  /**
   * Switches a drone on or off.
   *
   * @param answer receives the reason if one of the ports is not available; empty on success
   */
  public void switchPower(int drone, boolean on, Consumer<Optional<PortTakenException>> answer) {
    submit(
        () -> simulation.carryOut(new Control.Power(drone, on)),
        refusal -> {
          refusal.ifPresent(why -> refused.accept(why, drone));
          answer.accept(refusal);
        });
  }

  /** Sets a listener that receives the reason whenever a drone cannot be switched on. */
  public void onRefused(ObjIntConsumer<PortTakenException> listener) {
    refused = listener;
  }

  /** Carries out any control other than the power switch. */
  public void carryOut(Control control) {
    if (control instanceof Control.Power) {
      throw new IllegalArgumentException("the power switch is switchPower's");
    }
    submit(() -> simulation.carryOut(control), refusal -> {});
  }

  /** Pauses or resumes time. */
  public void togglePause() {
    submit(
        () -> simulation.carryOut(new Control.Pause(!simulation.snapshot().clock().paused())),
        refusal -> {});
  }

  /**
   * Sets the port on which a drone listens when it is next switched on.
   *
   * @param done called when the port is set
   */
  public void setCommandPort(int drone, int port, Runnable done) {
    submit(() -> simulation.setCommandPort(drone, port), refusal -> done.run());
  }

  /**
   * Makes the drones reachable or unreachable from other machines, with immediate effect.
   *
   * @param done called when the change has taken effect
   */
  public void setReachableFromNetwork(boolean reachable, Runnable done) {
    submit(
        () -> simulation.setReach(reachable ? Reach.NETWORK : Reach.THIS_MACHINE),
        refusal -> done.run());
  }

  private void submit(Task task, Consumer<Optional<PortTakenException>> answer) {
    pending.incrementAndGet();
    tasks.add(
        () -> {
          Runnable result = () -> {}; // any other failure is only logged
          try {
            task.run();
            result = () -> answer.accept(Optional.empty());
          } catch (PortTakenException e) {
            result = () -> answer.accept(Optional.of(e));
          } finally {
            answers.add(result);
            answered.run();
          }
        });
  }

  /**
   * Returns whether any action is pending, which means that snapshots do not show its result yet.
   * Thread-safe.
   */
  public boolean pending() {
    return pending.get() > 0;
  }

  /**
   * Runs an action once snapshots show the results of all earlier actions, or immediately if they
   * already do.
   */
  public void afterPending(Runnable next) {
    if (pending()) {
      submit(() -> {}, refusal -> next.run());
    } else {
      next.run();
    }
  }

  /**
   * Collects the answers that have arrived. Must be called before a snapshot is taken, so that the
   * snapshot shows their results.
   */
  void collect() {
    for (Runnable answer = answers.poll(); answer != null; answer = answers.poll()) {
      due.add(answer);
    }
  }

  /** Delivers the collected answers. Must be called before views read the snapshot. */
  void deliver() {
    for (Runnable answer = due.poll(); answer != null; answer = due.poll()) {
      pending.decrementAndGet();
      answer.run();
    }
  }

  /**
   * Sets a listener that is notified on the JavaFX thread, once for each reason why drones are not
   * receiving or sending anything.
   */
  public void onSilence(Consumer<Silence> listener) {
    simulation.onSilence(silence -> Platform.runLater(() -> listener.accept(silence)));
  }

  /** Returns the addresses at which a drone listens while it is on. */
  public List<InetSocketAddress> addresses(int drone) {
    return simulation.addresses(drone);
  }

  /** Returns whether other machines on the local networks can reach the drones. */
  public boolean reachableFromNetwork() {
    return simulation.reach() == Reach.NETWORK;
  }

  /** Returns the traffic that a drone has received and sent. */
  public Traffic traffic(int drone) {
    return simulation.traffic(drone);
  }

  /** Stops the worker. Waiting tasks are dropped. */
  @Override
  public void close() {
    worker.end();
    tasks.add(() -> {}); // wakes the worker, so that it ends
  }
}
