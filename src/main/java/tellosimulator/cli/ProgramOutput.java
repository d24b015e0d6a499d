package tellosimulator.cli;

import java.io.PrintStream;
import java.util.function.Supplier;
import tellosimulator.words.Translation;

/**
 * Where the program writes to, and in which language; and what a person says to it. For one thread.
 *
 * @param out takes results
 * @param err takes sentences about what went wrong
 * @param translation finds the language of the program, which takes a file to be read
 * @param input what comes from a person meanwhile
 */
public record ProgramOutput(
    PrintStream out, PrintStream err, Supplier<Translation> translation, ProgramInput input) {}
