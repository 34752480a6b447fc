/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_INTERRUPT_H
#define WF_BASE_INTERRUPT_H
/* Ending a run early. The program catches SIGINT, SIGTERM and SIGHUP; long loops look at wf_interrupted()
 * between two solutions and return WF_EINTERRUPTED. A program that only uses the library catches nothing. */

/* Catch the three signals from now on, those that are not ignored already. The first one is noted; after it
 * all have their usual effect again, so that a second one ends the program at once. */
void wf_interrupt_catch(void);
/* Number of the signal that was caught; 0: none. */
int wf_interrupted(void);
#endif
