/** What differs between two flights with the same commands, command by command. */
package tellosimulator.comparison;
