package tellosimulator.concurrent;

import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.IntConsumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Handles the signals that ask the program to end, namely INT (Ctrl-C), TERM and HUP, until this
 * object is closed. Without a handler, the JVM would exit at the first signal. The class uses
 * reflection, because javac warns about each use of {@code sun.misc.Signal}, which has no
 * replacement. Not thread-safe.
 */
public final class TerminationSignals implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(TerminationSignals.class);

  /** Signal numbers. Documented: POSIX. */
  private static final Map<String, Integer> NUMBERS = Map.of("HUP", 1, "INT", 2, "TERM", 15);

  private final Map<Object, Object> before = new LinkedHashMap<>();

  private TerminationSignals() {}

  /**
   * Starts to handle the signals as far as the JVM permits. The JVM permits no handler for a signal
   * that is ignored, and none at all if it runs with {@code -Xrs}.
   *
   * @param handler called with the number of each signal, on a thread of the JVM
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
      LOG.debug("The handler for signal {} could not be installed", name, e);
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
            LOG.debug("The previous handler for signal {} could not be restored", signal, e);
          }
        });
  }
}
