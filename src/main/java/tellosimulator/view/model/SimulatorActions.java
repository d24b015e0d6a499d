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
 * What the window can do to the simulation: one message for each thing that a person does. For the
 * JavaFX thread, which never waits: a worker carries them out in their order, because a port may
 * take a while to open and a busy simulation a while to answer. Answers come at the pulse whose
 * snapshot shows what was done.
 */
public final class SimulatorActions implements AutoCloseable {

  /** Something that may take a while. */
  @FunctionalInterface
  private interface Task {
    void run() throws PortTakenException;
  }

  private final OnlineSimulation simulation;
  private final BlockingQueue<Runnable> tasks = new LinkedBlockingQueue<>();
  private final Queue<Runnable> answers = new ConcurrentLinkedQueue<>();

  /** Those that came before the snapshot that the window shows was taken. */
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
   * Tells somebody whenever there is something to {@link #collect}.
   *
   * @param listener is called on the worker's thread
   */
  void onAnswered(Runnable listener) {
    answered = listener;
  }

  /** Carries out one task after the other; what fails is told, and the next one is tried. */
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

  /** Uses a drone's power switch. */
  public void switchPower(int drone, boolean on) {
    switchPower(drone, on, refusal -> {});
  }

  /**
   * Uses a drone's power switch.
   *
   * @param answer takes why it stays off, if one of its ports cannot be had; empty if it was done
   */
  public void switchPower(int drone, boolean on, Consumer<Optional<PortTakenException>> answer) {
    submit(
        () -> simulation.carryOut(new Control.Power(drone, on)),
        refusal -> {
          refusal.ifPresent(why -> refused.accept(why, drone));
          answer.accept(refusal);
        });
  }

  /** Tells somebody of each drone that stays off, and why. */
  public void onRefused(ObjIntConsumer<PortTakenException> listener) {
    refused = listener;
  }

  /** Does anything else than using the power switch. */
  public void carryOut(Control control) {
    if (control instanceof Control.Power) {
      throw new IllegalArgumentException("the power switch is switchPower's");
    }
    submit(() -> simulation.carryOut(control), refusal -> {});
  }

  /** Lets time stand still, or go on. */
  public void togglePause() {
    submit(
        () -> simulation.carryOut(new Control.Pause(!simulation.snapshot().clock().paused())),
        refusal -> {});
  }

  /**
   * Lets a drone listen on another port from the next time it is switched on.
   *
   * @param done is called when it does
   */
  public void setCommandPort(int drone, int port, Runnable done) {
    submit(() -> simulation.setCommandPort(drone, port), refusal -> done.run());
  }

  /**
   * Lets other machines reach the drones, or no longer; at once.
   *
   * @param done is called when they do
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
          Runnable result = () -> {}; // what fails is logged, and nobody goes on as if it were done
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

  /** Whether something was not carried out yet, so that snapshots do not show it; any thread. */
  public boolean pending() {
    return pending.get() > 0;
  }

  /** Does something as soon as all that was done before is shown by snapshots; at once if it is. */
  public void afterPending(Runnable next) {
    if (pending()) {
      submit(() -> {}, refusal -> next.run());
    } else {
      next.run();
    }
  }

  /** Takes the answers that have come; called before a snapshot is taken, which so shows them. */
  void collect() {
    for (Runnable answer = answers.poll(); answer != null; answer = answers.poll()) {
      due.add(answer);
    }
  }

  /** Hands over what was collected; called before views look at the snapshot. */
  void deliver() {
    for (Runnable answer = due.poll(); answer != null; answer = due.poll()) {
      pending.decrementAndGet();
      answer.run();
    }
  }

  /**
   * Sets a listener that is notified on the JavaFX thread, once for each reason why nothing comes
   * to drones or from them.
   */
  public void onSilence(Consumer<Silence> listener) {
    simulation.onSilence(silence -> Platform.runLater(() -> listener.accept(silence)));
  }

  /** Where a drone listens while it is on. */
  public List<InetSocketAddress> addresses(int drone) {
    return simulation.addresses(drone);
  }

  /** Whether other machines of the local networks reach the drones. */
  public boolean reachableFromNetwork() {
    return simulation.reach() == Reach.NETWORK;
  }

  /** What a drone received and sent. */
  public Traffic traffic(int drone) {
    return simulation.traffic(drone);
  }

  /** Carries out nothing more; what waits is dropped. */
  @Override
  public void close() {
    worker.end();
    tasks.add(() -> {}); // which lets it see that it has ended
  }
}
