package tellosimulator.concurrent;

import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.IntConsumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Takes the signals that ask the program to end, INT (Ctrl-C), TERM and HUP, until it is closed;
 * the Java machine would end at the first and take no second one. It goes through reflection, as
 * javac warns of each use of {@code sun.misc.Signal}, which has no successor. For one thread.
 */
public final class TerminationSignals implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(TerminationSignals.class);

  /** Their numbers. Documented: POSIX. */
  private static final Map<String, Integer> NUMBERS = Map.of("HUP", 1, "INT", 2, "TERM", 15);

  private final Map<Object, Object> before = new LinkedHashMap<>();

  private TerminationSignals() {}

  /**
   * Takes them from now on, as far as the Java machine lets it; it has those that are ignored, and
   * all of them with {@code -Xrs}.
   *
   * @param handler gets the number of each signal, on a thread of its own
   */
  public static TerminationSignals take(IntConsumer handler) {
    TerminationSignals taken = new TerminationSignals();
    NUMBERS.forEach((name, number) -> taken.take(name, () -> handler.accept(number)));
    return taken;
  }

  private void take(String name, Runnable task) {
    try {
      Class<?> type = Class.forName("sun.misc.SignalHandler");
      Object handler =
          Proxy.newProxyInstance(
              type.getClassLoader(),
              new Class<?>[] {type},
              (proxy, method, arguments) -> {
                task.run();
                return null;
              });
      Object signal =
          Class.forName("sun.misc.Signal").getConstructor(String.class).newInstance(name);
      before.put(signal, handle(signal, handler));
    } catch (ReflectiveOperationException e) {
      LOG.debug("The signal {} is not taken", name, e);
    }
  }

  private static Object handle(Object signal, Object handler) throws ReflectiveOperationException {
    Method handle =
        signal
            .getClass()
            .getMethod("handle", signal.getClass(), Class.forName("sun.misc.SignalHandler"));
    return handle.invoke(null, signal, handler);
  }

  @Override
  public void close() {
    before.forEach(
        (signal, handler) -> {
          try {
            handle(signal, handler);
          } catch (ReflectiveOperationException e) {
            LOG.debug("The signal {} is not given back", signal, e);
          }
        });
  }
}
