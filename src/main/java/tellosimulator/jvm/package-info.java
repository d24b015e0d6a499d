/**
 * Limits the memory of the process.
 *
 * <p>{@link tellosimulator.jvm.ProcessMemory} sets JVM options at run time, because a jar cannot
 * set options on the JVM's command line. The package imports {@code concurrent} and {@code time}.
 * It does not reduce the memory that the program itself uses, such as the memory for textures.
 */
package tellosimulator.jvm;
