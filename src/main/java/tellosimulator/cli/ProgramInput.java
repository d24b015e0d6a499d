package tellosimulator.cli;

import java.io.InputStream;
import java.util.function.Consumer;

/**
 * The standard input of the program, and the registration of shutdown tasks. Not thread-safe.
 *
 * @param in the standard input
 * @param atEnd registers a task that runs on its own thread when the program is asked to end
 */
public record ProgramInput(InputStream in, Consumer<Runnable> atEnd) {}
