package tellosimulator.cli;

import java.io.InputStream;
import java.util.function.Consumer;

/**
 * The standard input of the program, and where to register shutdown tasks. For one thread.
 *
 * @param in what is typed
 * @param atEnd takes what is to be done when the program is told to end, on a thread of its own
 */
public record ProgramInput(InputStream in, Consumer<Runnable> atEnd) {}
